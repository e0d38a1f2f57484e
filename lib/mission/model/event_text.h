// What an event of a mission is, in words.
#pragma once

#include <string>
#include <vector>

#include "lib/mission/model/event.h"

namespace shoal {

/// Returns "deploy to alpha", "comms_range = 100", "STATUS of alpha to bravo".
[[nodiscard]] std::string EventText(const Event& event);

/// Returns the vehicle that the event names, "all" too; empty: none.
[[nodiscard]] std::string VehicleOf(const Event& event);

}  // namespace shoal
