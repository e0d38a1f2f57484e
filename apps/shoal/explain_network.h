// What a mission's acoustic networks and its swarms come to: channels, slots and recovery, as
// comments below the mission that `shoal check --explain` prints.
#pragma once

#include <string>

#include "lib/mission/model/mission.h"

namespace shoal {

/// Returns lines that begin with "#"; empty for a mission without an acoustic network.
[[nodiscard]] std::string ExplainNetwork(const Mission& mission);

}  // namespace shoal
