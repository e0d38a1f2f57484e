// Messages from outside the step protocol reach broker and recorder each on its own way: what the
// broker handled in one step may stand in the log a step earlier or later.
#pragma once

#include <cstdint>

#include "lib/analysis/comms_log.h"

namespace shoal {

/// Moves inputs by one step to where the recorded decisions, or the recorded rules, say that the
/// broker handled them. Returns how many. Only for recordings in mission time, of which no reports
/// are missing; 0 for others.
[[nodiscard]] int64_t MoveToTheStepsOfTheBroker(CommsLog* log);

}  // namespace shoal
