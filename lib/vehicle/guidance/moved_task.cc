#include "lib/vehicle/guidance/moved_task.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace shoal {

namespace {

constexpr double kMaxMovedLanes = 10'000;

using Points = std::vector<Eigen::Vector2d>;

// Each returns what is wrong, or an empty text and has moved the task.

std::string OnePoint(const Points& points_m, std::string_view kind, Eigen::Vector2d* point_m) {
  if (points_m.size() != 1) return std::string(kind) + " has one place: give X Y";
  *point_m = points_m.front();
  return {};
}

std::string Move(WaypointsTask& task, const Points& points_m) {
  task.points_m = points_m;
  return {};
}

std::string Move(PathFollowTask& task, const Points& points_m) {
  if (!task.parts.empty()) return "a path of parts cannot be moved: only one of points can";
  if (points_m.size() != task.points_m.size()) {
    return "path_follow has " + std::to_string(task.points_m.size()) +
           " points, each with its depth: give as many";
  }
  for (size_t i = 0; i < points_m.size(); ++i) task.points_m[i].head<2>() = points_m[i];
  return {};
}

std::string Move(SurveyTask& task, const Points& points_m) {
  if (points_m.size() < 3) return "a survey has three corners or more";
  if (!task.divide_among.empty()) return "a survey that is divided among vehicles cannot be moved";
  if (std::string problem = PolygonProblem(points_m); !problem.empty()) return problem;
  task.area.polygon_m = points_m;
  if (CountLanes(task.area) > kMaxMovedLanes) return "the polygon has more than 10,000 lanes";
  return PointsOf(task).empty() ? "the polygon has no lane: it is too small" : "";
}

std::string Move(LoiterTask& task, const Points& points_m) {
  return OnePoint(points_m, LoiterTask::kKind, &task.center_m);
}

std::string Move(StationKeepTask& task, const Points& points_m) {
  task.here = false;
  return OnePoint(points_m, StationKeepTask::kKind, &task.point_m);
}

std::string Move(ReturnTask& task, const Points& points_m) {
  return OnePoint(points_m, ReturnTask::kKind, &task.point_m);
}

template <class T>
std::string Move(T& /*task*/, const Points& /*points_m*/) {
  return std::string(T::kKind) + " has no place that could be moved";
}

}  // namespace

Result<Task> MovedTask(const Task& task, std::span<const double> values) {
  if (values.empty() || values.size() % 2 != 0 || values.size() / 2 > kMaxMovedPoints) {
    return Error{"move takes X Y of each point, 1 to " + std::to_string(kMaxMovedPoints) +
                 " of them"};
  }
  Points points_m;
  for (size_t i = 0; i < values.size(); i += 2) {
    points_m.emplace_back(values[i], values[i + 1]);
    if (!(points_m.back().cwiseAbs().maxCoeff() <= kFarthestMove_m)) {
      return Error{"move needs coordinates within 1000 km"};
    }
  }
  Task moved = task;
  const std::string problem =
      std::visit([&](auto& what) { return Move(what, points_m); }, moved.what);
  if (!problem.empty()) return Error{problem};
  return moved;
}

}  // namespace shoal
