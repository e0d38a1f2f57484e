// The keys of a mission that `--set` can change: for the completion of shells.
//
//   for (const std::string& path : KeyPaths(mission, text)) puts(path.c_str());  //
//   comms.comms_range
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/model/mission.h"

namespace shoal {

/// Returns the path of every key of `mission`, defaults included, that an override of its file can
/// set. `text` is the file's. Vehicles of a fleet, and what a template gives a vehicle, are not in
/// the file under their own names and so are left out; keys of the fleet's own are too.
/// @pre `mission` was loaded from `text` without errors.
[[nodiscard]] std::vector<std::string> KeyPaths(const Mission& mission, std::string_view text);

}  // namespace shoal
