// Names the build of the program that runs: two that differ may give different results.
#pragma once

#include <string>

namespace shoal {

/// Returns 16 hexadecimal digits that follow from the linker's build ids of the program and of
/// shoal's own shared libraries; "unknown" where the program was linked without.
[[nodiscard]] std::string BuildId();

}  // namespace shoal
