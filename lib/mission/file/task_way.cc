#include "lib/mission/file/task_way.h"

#include <algorithm>
#include <span>
#include <variant>

#include "lib/vehicle/guidance/survey_lanes.h"

namespace shoal {

namespace {

std::vector<Eigen::Vector3d> AtSurface(std::span<const Eigen::Vector2d> points_m) {
  std::vector<Eigen::Vector3d> lifted_m;
  lifted_m.reserve(points_m.size());
  for (const Eigen::Vector2d& point_m : points_m) {
    lifted_m.emplace_back(point_m.x(), point_m.y(), 0);
  }
  return lifted_m;
}

}  // namespace

std::optional<TaskWay> WayOf(const Task& task) {
  if (const auto* waypoints = std::get_if<WaypointsTask>(&task.what)) {
    return TaskWay{AtSurface(waypoints->points_m), waypoints->speed_mps, "points"};
  }
  if (const auto* survey = std::get_if<SurveyTask>(&task.what)) {
    const std::vector<SurveyLane> lanes = LanesOver(survey->area);
    return TaskWay{AtSurface(PathAlong(ShareOf(lanes, survey->share), survey->route)),
                   survey->speed_mps, ""};
  }
  if (const auto* path = std::get_if<PathFollowTask>(&task.what)) {
    return TaskWay{PathOf(*path).path.points_m, path->speed_mps,
                   path->parts.empty() ? "points" : "path"};
  }
  return std::nullopt;
}

double LengthFrom_m(const Eigen::Vector3d& from_m, const TaskWay& way) {
  double length_m = 0;
  Eigen::Vector3d last_m = from_m;
  for (const Eigen::Vector3d& point_m : way.points_m) {
    length_m += (point_m - last_m).norm();
    last_m = point_m;
  }
  return length_m;
}

double DeepestOf_m(const Vehicle& vehicle) {
  double deepest_m = vehicle.start.depth_m;
  for (const Task& task : vehicle.tasks) {
    const std::optional<TaskWay> way = WayOf(task);
    if (!way) continue;
    for (const Eigen::Vector3d& point_m : way->points_m) {
      deepest_m = std::max(deepest_m, point_m.z());
    }
  }
  return deepest_m;
}

}  // namespace shoal
