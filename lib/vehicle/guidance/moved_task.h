// A task that lies elsewhere: what the order `move` makes of it.
#pragma once

#include <span>

#include "lib/base/check/result.h"
#include "lib/vehicle/guidance/task.h"

namespace shoal {

/// Coordinates beyond this are refused, m.
inline constexpr double kFarthestMove_m = 1e6;
/// More points are refused.
inline constexpr size_t kMaxMovedPoints = 1000;

/// Returns `task` with other places, `values` being x East and y North of each, m:
///
///   waypoints      its points, one or more
///   path_follow    its points, as many as it has, each at its depth; not of a path of parts
///   survey         the corners of its polygon, three or more
///   loiter         its centre
///   station_keep   its point
///   return         its point
///
/// Or what is wrong: a kind that has no place, another number of values, a polygon that crosses
/// itself or has no lane.
[[nodiscard]] Result<Task> MovedTask(const Task& task, std::span<const double> values);

}  // namespace shoal
