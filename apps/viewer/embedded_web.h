// What cmake/EmbedWeb.cmake writes: the files of web/ as bytes of this program.
#pragma once

#include <span>

#include "lib/base/check/embedded_file.h"

namespace shoal {

std::span<const EmbeddedFile> EmbeddedWeb();

}  // namespace shoal
