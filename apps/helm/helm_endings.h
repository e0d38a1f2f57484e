// What a vehicle does when its tasks are done, and how it keeps station by order: the tasks that
// follow from where it is then.
#pragma once

#include "lib/mission/model/vehicle.h"
#include "lib/vehicle/guidance/task_runner.h"

namespace shoal {

class HelmEndings {
 public:
  explicit HelmEndings(const Vehicle& vehicle);

  /// Returns the ending of the list whose last task was `last`; nullptr: the list is empty.
  Ending AfterList(const Task* last) const;

  /// Returns what to do from `fix` on, where `last` was steered before. kEndMission is the ending
  /// that the vehicle would have without it.
  TaskRunner::What TaskFor(Ending ending, const Fix& fix, const Guidance& last) const;

  /// Returns the task that keeps station about a point, at the depth of `fix`.
  StationKeepTask HoldAt(const Eigen::Vector2d& point_m, const Fix& fix) const;

  /// Returns a task of the list as this vehicle does it: one that keeps a place keeps a depth, that
  /// of the vehicle's tasks that name none.
  TaskRunner::What AtItsDepth(TaskRunner::What what) const;

 private:
  HelmOptions options_;
  bool is_underwater_;
  std::optional<double> cruise_depth_m_;  ///< Of a vehicle that dives.
};

}  // namespace shoal
