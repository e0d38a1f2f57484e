#include "lib/vehicle/guidance/task.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

TaskFacts FactsOfKind(const WaypointsTask& task) {
  TaskFacts facts{.ends = task.laps != 0,
                  .outline = {.points_m = task.points_m, .closed = task.laps != 1}};
  if (task.laps != 0) facts.most_laps = task.laps;
  return facts;
}

TaskFacts FactsOfKind(const LoiterTask& task) {
  return {.ends = task.duration_s != 0,
          .outline = {.points_m = CornersOf(task),
                      .closed = true,
                      .circle = {{.center_m = task.center_m, .radius_m = task.radius_m}}}};
}

TaskFacts FactsOfKind(const StationKeepTask& task) {
  TaskFacts facts{.most_laps = 0, .outline = {.radius_m = task.outer_radius_m}};
  if (!task.here) facts.outline.points_m.push_back(task.point_m);
  return facts;
}

TaskFacts FactsOfKind(const ReturnTask& task) {
  return {.most_laps = 1, .outline = {.points_m = {task.point_m}}};
}

TaskFacts FactsOfKind(const PathFollowTask& task) {
  const bool repeats = task.end == PathTaskEnd::kReturnToFirst;
  const JoinedPath path = PathOf(task);
  TaskFacts facts{.is_underwater = true,
                  .ends = task.end == PathTaskEnd::kDone || task.end == PathTaskEnd::kSurface,
                  .outline = {.closed = repeats, .marks_points = !path.has_curves}};
  if (!repeats) facts.most_laps = 1;
  for (const Eigen::Vector3d& point_m : path.path.points_m) {
    facts.outline.points_m.emplace_back(point_m.head<2>());
  }
  return facts;
}

TaskFacts FactsOfKind(const TargetTrackTask& task) {
  return {
      .is_underwater = true, .ends = task.on_target_end == TargetEndRule::kDone, .most_laps = 0};
}

TaskFacts FactsOfKind(const SurfaceTask&) {
  return {.is_underwater = true, .ends = true, .most_laps = 0};
}

TaskFacts FactsOfKind(const SurfaceForFixTask&) {
  return {.is_underwater = true, .ends = true, .most_laps = 0};
}

TaskFacts FactsOfKind(const SurveyTask& task) {
  return {.ends = true,
          .most_laps = 1,
          .outline = {.points_m = PointsOf(task),
                      .area_m = task.area.polygon_m,
                      .marks_points = task.route.turn_radius_m == 0}};
}

template <size_t... kPlaces>
std::vector<Task> TasksAt(std::index_sequence<kPlaces...> /*places*/) {
  using What = decltype(Task::what);
  return {Task{.name = {}, .what = What(std::in_place_index<kPlaces>)}...};
}

}  // namespace

std::string_view KindOf(const Task& task) {
  return std::visit([](const auto& what) { return std::decay_t<decltype(what)>::kKind; },
                    task.what);
}

TaskFacts FactsOf(const Task& task) {
  return std::visit([](const auto& what) { return FactsOfKind(what); }, task.what);
}

std::vector<Task> OneTaskOfEachKind() {
  return TasksAt(std::make_index_sequence<std::variant_size_v<decltype(Task::what)>>());
}

StationKeepTask HoldHere(double radius_m, std::optional<double> z_m) {
  StationKeepTask keep;
  keep.inner_radius_m = 0.4 * radius_m;
  keep.outer_radius_m = radius_m;
  keep.speed_mps = 1.5;  // The fins hold it, and it makes way against a current.
  keep.stops_first = true;
  keep.z_m = z_m;
  return keep;
}

std::vector<Eigen::Vector2d> CornersOf(const LoiterTask& task) {
  std::vector<Eigen::Vector2d> corners_m;
  const int num_points = std::max(task.num_points, 3);
  const double step_rad = (task.clockwise ? 2 : -2) * kPi / num_points;
  corners_m.reserve(static_cast<size_t>(num_points));
  for (int i = 0; i < num_points; ++i) {
    corners_m.push_back(task.center_m + task.radius_m * UnitVector(i * step_rad));
  }
  return corners_m;
}

JoinedPath PathOf(const PathFollowTask& task) {
  JoinedPath joined =
      task.parts.empty() ? JoinedPath{.path = {task.points_m}} : Join(task.parts, task.start);
  if (task.turn_radius_m > 0) joined = RoundCorners(joined, task.turn_radius_m);
  return joined;
}

std::vector<Eigen::Vector2d> PointsOf(const SurveyTask& task) {
  const std::vector<SurveyLane> lanes = LanesOver(task.area);
  return PathAlong(ShareOf(lanes, task.share), task.route);
}

}  // namespace shoal
