#include "lib/mission/plan/plan_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/mission/plan/plan_text.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

namespace {

using Points = std::vector<Eigen::Vector2d>;

/// Returns "10.5" or "10".
std::string NumberText(double value) {
  std::string text = fmt::format("{:.1f}", value);
  if (text.ends_with(".0")) text.erase(text.size() - 2);
  return text == "-0" ? "0" : text;
}

std::string PointText(const Eigen::Vector2d& point_m) {
  return fmt::format("[{}, {}]", NumberText(point_m.x()), NumberText(point_m.y()));
}

std::string PointsText(const Points& points_m) {
  std::string text = "[";
  for (const Eigen::Vector2d& point_m : points_m) {
    if (text.size() > 1) text += ", ";
    text += PointText(point_m);
  }
  return text + "]";
}

std::string Replaced(std::string_view text, TextSpan span, std::string_view by) {
  return std::string(text.substr(0, span.begin)).append(by).append(text.substr(span.end));
}

bool ArePlaces(const Points& points_m) {
  return std::all_of(points_m.begin(), points_m.end(), [](const Eigen::Vector2d& point_m) {
    return point_m.allFinite() && point_m.cwiseAbs().maxCoeff() <= kFarthestPlan_m;
  });
}

const Error kNoPlace{"a place lies within 1000 km of the mission's origin"};

/// Makes each kind of change.
struct Editor {
  std::string_view text;
  const PlanText& plan;

  const PlanHandle* Handle(size_t number) const {
    return number < plan.handles.size() ? &plan.handles[number] : nullptr;
  }
  static Error NoHandle() { return Error{"the file has no such place any more: look again"}; }

  Result<std::string> operator()(const MovePoint& move) const {
    const PlanHandle* handle = Handle(move.handle);
    if (handle == nullptr || move.point >= handle->points.size()) return NoHandle();
    if (!ArePlaces({move.to_m})) return kNoPlace;
    const PlanPoint& point = handle->points[move.point];
    const std::string x = NumberText(move.to_m.x());
    const std::string y = NumberText(move.to_m.y());
    if (point.x.empty()) {
      const bool needs_break = point.whole.begin > 0 && text[point.whole.begin - 1] != '\n';
      return Replaced(
          text, point.whole,
          fmt::format("{}start = {{x_m = {}, y_m = {}}}\n", needs_break ? "\n" : "", x, y));
    }
    // The later one first, so that the other stays where it is.
    const bool y_is_later = point.y.begin > point.x.begin;
    const std::string once = Replaced(text, y_is_later ? point.y : point.x, y_is_later ? y : x);
    return Replaced(once, y_is_later ? point.x : point.y, y_is_later ? x : y);
  }

  Result<std::string> operator()(const InsertPoint& insert) const {
    const PlanHandle* handle = Handle(insert.handle);
    if (handle == nullptr || insert.before > handle->points.size()) return NoHandle();
    if (handle->shape == PlanShape::kPoint) return Error{"this is one place alone"};
    if (!ArePlaces({insert.at_m})) return kNoPlace;
    const bool is_last = insert.before == handle->points.size();
    const PlanPoint& beside = handle->points[is_last ? insert.before - 1 : insert.before];
    const std::string made = LikePoint(beside, insert.at_m);
    const size_t at = is_last ? beside.whole.end : beside.whole.begin;
    return Replaced(text, {at, at}, is_last ? ", " + made : made + ", ");
  }

  /// A third number, the depth, is that of the neighbour.
  std::string LikePoint(const PlanPoint& beside, const Eigen::Vector2d& at_m) const {
    const std::string_view rest = text.substr(beside.y.end, beside.whole.end - beside.y.end);
    const bool is_plain = rest.find_first_of("#\n") == rest.npos && rest.find(',') != rest.npos;
    if (!is_plain) return PointText(at_m);
    return fmt::format("[{}, {}{}", NumberText(at_m.x()), NumberText(at_m.y()), rest);
  }

  Result<std::string> operator()(const RemovePoint& remove) const {
    const PlanHandle* handle = Handle(remove.handle);
    if (handle == nullptr || remove.point >= handle->points.size()) return NoHandle();
    const size_t least = handle->shape == PlanShape::kPolygon ? 3 : 1;
    if (handle->shape == PlanShape::kPoint || handle->points.size() <= least) {
      return Error{handle->shape == PlanShape::kPolygon ? "a polygon has three corners or more"
                                                        : "its last point must stay"};
    }
    // With the comma and the blanks to its neighbour.
    const bool is_first = remove.point == 0;
    const TextSpan own = handle->points[remove.point].whole;
    const TextSpan span = is_first ? TextSpan{own.begin, handle->points[1].whole.begin}
                                   : TextSpan{handle->points[remove.point - 1].whole.end, own.end};
    return Replaced(text, span, "");
  }

  Result<std::string> operator()(const AddTask& add) const {
    const auto vehicle =
        std::find_if(plan.vehicles.begin(), plan.vehicles.end(),
                     [&](const PlanVehicle& each) { return each.name == add.vehicle; });
    if (vehicle == plan.vehicles.end()) {
      return Error{
          fmt::format("the file has no [[vehicle]] {}: one of a fleet has its template's "
                      "tasks",
                      Quoted(add.vehicle))};
    }
    if (!ArePlaces(add.points_m) || add.points_m.empty()) return kNoPlace;
    Result<std::string> keys = KeysOf(add);
    if (!keys.ok()) return keys;
    return Inserted(vehicle->end,
                    fmt::format("\n[[vehicle.task]]\nname = \"{}\"\nkind = \"{}\"\n{}",
                                FreeName(*vehicle, add.kind), add.kind, *keys));
  }

  static Result<std::string> KeysOf(const AddTask& add) {
    const Points& points_m = add.points_m;
    if (add.kind == "waypoints") return fmt::format("points = {}\n", PointsText(points_m));
    if (add.kind == "station_keep") return fmt::format("point = {}\n", PointText(points_m[0]));
    if (add.kind == "loiter") {
      constexpr double kRadius_m = 30;
      const double radius_m = points_m.size() > 1
                                  ? std::max(1.0, Hypot(points_m[1].x() - points_m[0].x(),
                                                        points_m[1].y() - points_m[0].y()))
                                  : kRadius_m;
      return fmt::format("center = {}\nradius_m = {}\n", PointText(points_m[0]),
                         NumberText(radius_m));
    }
    if (add.kind != "survey") {
      return Error{fmt::format("{} cannot be drawn: waypoints, loiter, station_keep and survey can",
                               Quoted(add.kind))};
    }
    if (points_m.size() < 3) return Error{"a survey has three corners or more"};
    return fmt::format("polygon = {}\nlane_spacing_m = {}\n", PointsText(points_m),
                       NumberText(SpacingOver(points_m)));
  }

  /// About eight lanes, in whole metres.
  static double SpacingOver(const Points& points_m) {
    constexpr double kLanes = 8;
    Eigen::Vector2d low = points_m[0];
    Eigen::Vector2d high = points_m[0];
    for (const Eigen::Vector2d& point_m : points_m) {
      low = low.cwiseMin(point_m);
      high = high.cwiseMax(point_m);
    }
    return std::max(1.0, std::round((high - low).minCoeff() / kLanes));
  }

  static std::string FreeName(const PlanVehicle& vehicle, std::string_view kind) {
    for (int number = 1;; ++number) {
      std::string name = number == 1 ? fmt::format("planned_{}", kind)
                                     : fmt::format("planned_{}_{}", kind, number);
      if (std::find(vehicle.task_names.begin(), vehicle.task_names.end(), name) ==
          vehicle.task_names.end()) {
        return name;
      }
    }
  }

  Result<std::string> operator()(const AddObstacle& add) const {
    if (!ArePlaces(add.points_m)) return kNoPlace;
    if (add.points_m.size() < 3) return Error{"an obstacle has three corners or more"};
    std::string id;
    for (int number = 1; id.empty(); ++number) {
      const std::string name = fmt::format("planned_{}", number);
      const bool is_taken = std::any_of(
          plan.handles.begin(), plan.handles.end(),
          [&](const PlanHandle& each) { return each.kind == "obstacle" && each.name == name; });
      if (!is_taken) id = name;
    }
    return Inserted(text.size(), fmt::format("\n[[obstacle]]\nid = \"{}\"\npolygon = {}\n", id,
                                             PointsText(add.points_m)));
  }

  Result<std::string> operator()(const AddArea& add) const {
    if (!ArePlaces(add.points_m)) return kNoPlace;
    if (add.points_m.size() < 3) return Error{"an area has three corners or more"};
    const bool has_one = std::any_of(plan.handles.begin(), plan.handles.end(),
                                     [](const PlanHandle& each) { return each.kind == "op_area"; });
    if (has_one) return Error{"the mission has an op_area: move its corners"};
    if (!plan.mission_keys) return Error{"the file has no [mission]"};
    return Inserted(*plan.mission_keys, fmt::format("op_area = {}\n", PointsText(add.points_m)));
  }

  /// `at` is the begin of a line, or the end of a text that may lack its last line break.
  std::string Inserted(size_t at, std::string lines) const {
    if (at > 0 && text[at - 1] != '\n') lines.insert(0, "\n");
    return Replaced(text, {at, at}, lines);
  }
};

}  // namespace

Result<std::string> EditPlan(std::string_view text, const PlanEdit& edit) {
  const std::optional<PlanText> plan = ReadPlan(text);
  if (!plan) return Error{"the text is not TOML: correct its errors first"};
  return std::visit(Editor{text, *plan}, edit);
}

}  // namespace shoal
