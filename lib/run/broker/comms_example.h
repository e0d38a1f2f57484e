// The table [comms] of a mission file with every default, and what each rule does.
#pragma once

#include <string>

namespace shoal {

/// Returns "[comms]" and a line for each rule: "comms_range = 100  # m: ...".
[[nodiscard]] std::string CommsExample();

}  // namespace shoal
