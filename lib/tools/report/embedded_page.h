// What cmake/EmbedWeb.cmake writes: the files of web/ that a campaign's page is made of.
#pragma once

#include <span>

#include "lib/base/check/embedded_file.h"

namespace shoal {

/// In the order of the list in lib/tools/report/CMakeLists.txt.
std::span<const EmbeddedFile> EmbeddedPage();

}  // namespace shoal
