// The way that a task leads along, where it is known beforehand.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "lib/mission/model/vehicle.h"
#include "lib/vehicle/guidance/task.h"

namespace shoal {

/// What a vehicle passes that does a task once, as it is written.
struct TaskWay {
  std::vector<Eigen::Vector3d> points_m;  ///< x East, y North, z down; 0 where the task has none.
  double speed_mps = 0;                   ///< Of the task.
  std::string_view key;                   ///< Of the mission file; empty: the table as a whole.
};

/// Returns nothing for tasks without points: the way of a loiter or of one that follows another
/// vehicle depends on what happens.
[[nodiscard]] std::optional<TaskWay> WayOf(const Task& task);

/// Returns how long it is from `from_m` to its last point.
[[nodiscard]] double LengthFrom_m(const Eigen::Vector3d& from_m, const TaskWay& way);

/// Returns the greatest depth that a vehicle starts at, or is led to by a task with points.
[[nodiscard]] double DeepestOf_m(const Vehicle& vehicle);

}  // namespace shoal
