// The text of every .lcm file of shoal, compiled in, so that `shoal log cat` can print messages of
// types that it was not written for.
#pragma once

#include <string_view>
#include <vector>

namespace shoal {

/// Returns the text of each file in lcmtypes/, in the order of lcmtypes/CMakeLists.txt.
const std::vector<std::string_view>& LcmSources();

}  // namespace shoal
