// Messages from outside the step protocol reach broker and recorder independently: the log may
// show them one step earlier or later than the step in which the broker handled them.
#pragma once

#include <cstdint>

#include "lib/tools/rebroker/comms_log.h"

namespace shoal {

/// Moves inputs by one step to where the recorded decisions, or the recorded rules, show that the
/// broker handled them. Returns how many it moved. Only for recordings in mission time, of which no
/// reports are missing; 0 for others.
[[nodiscard]] int64_t MoveToTheStepsOfTheBroker(CommsLog* log);

}  // namespace shoal
