// What a behavior is about in the plane, as it is drawn: waypoints, a loiter, a region, a leg, a
// station.
#pragma once

#include <vector>

#include "lib/helm/behaviors/any_behavior.h"
#include "lib/vehicle/guidance/task.h"

namespace shoal {

/// Returns the outlines, of the options as they are before the behavior runs: nothing of those
/// whose place is where the vehicle is when they begin, and of those that know of no place. An
/// op_region has one for each of its zones: core, save, halt.
[[nodiscard]] std::vector<TaskOutline> OutlinesOf(const AnyBehavior& what);

}  // namespace shoal
