// Path following with layers: the way to the waypoint is the least urgent of them.
#pragma once

#include "lib/vehicle/guidance/task_runner.h"

namespace shoal {

/// Weighs the way of `guidance`, as the path asks for it, with the layers of the task, and lists
/// what each asks for. Where they ask for nothing, or nothing is known of the surroundings, it
/// changes neither course nor speed nor depth, and returns false.
bool KeepClear(const PathFollowTask& task, const Fix& fix, Guidance* guidance);

}  // namespace shoal
