// What the vehicles of an imported mission will do once they are deployed.
#pragma once

#include <string>
#include <vector>

#include "lib/mission/model/mission.h"

namespace shoal {

struct VehicleOutlook {
  std::string vehicle;
  bool moves = false;
  /// Behaviors that move it, or why it stays: "leg waits for PATROL = true (shoal send patrol)".
  std::string why;
};

/// Returns what each vehicle does within a minute of `deploy`, and after each of the mission's
/// events: its behaviors decide, while it stays at its start. A vehicle with tasks moves.
[[nodiscard]] std::vector<VehicleOutlook> OutlooksOf(const Mission& mission);

}  // namespace shoal
