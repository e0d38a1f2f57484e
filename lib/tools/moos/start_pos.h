// Where uSimMarine starts a vehicle.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace shoal {

/// Returns the key of `start` for what uSimMarine calls it; empty: there is none.
[[nodiscard]] std::string_view StartKey(std::string_view moos_key);

/// Reads uSimMarine's start_pos: each part counts by its name, or else by its place among all,
/// named ones too. What it cannot read is 0; at a part that it refuses it stops. Returns what is
/// wrong.
std::string ReadStartPos(std::string_view text, std::map<std::string, double>* given);

}  // namespace shoal
