// The files of data that a mission file names: with other contents the mission is another one.
#pragma once

#include <string>
#include <vector>

#include "lib/mission/model/mission.h"

namespace shoal {

/// Returns their paths as the mission file has them, which count from its folder: the grids of
/// floor and current, then the tracks in the order of the vehicles, then what channels of sound
/// name. Each once.
[[nodiscard]] std::vector<std::string> DataFilesOf(const Mission& mission);

}  // namespace shoal
