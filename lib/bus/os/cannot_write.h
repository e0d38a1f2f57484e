// The error of a file that cannot be written.
#pragma once

#include <string>

#include "lib/base/check/result.h"

namespace shoal {

/// Returns "cannot write <path>: <the system's reason> (<what to try>)" of an errno.
[[nodiscard]] Error CannotWrite(const std::string& path, int error_number);

}  // namespace shoal
