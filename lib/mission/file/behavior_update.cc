#include "lib/mission/file/behavior_update.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/geometry/convex_polygon.h"
#include "lib/base/text/numbers.h"
#include "lib/helm/modes/value_text.h"
#include "lib/mission/file/describe.h"
#include "lib/mission/toml/polygon_text.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/update_reader.h"

namespace shoal {

namespace {

constexpr double kLeastRadius_m = 5;

/// Takes the items that change what is there, instead of replacing it.
class Modifier {
 public:
  Modifier(BehaviorOptions& options, const Eigen::Vector2d& position_m)
      : options_(options), position_m_(position_m) {}

  /// Returns true where it is an item of this sort; it has been applied, or problem() is not empty.
  bool Apply(const UpdateItem& item) {
    if (auto* waypoint = std::get_if<WaypointOptions>(&options_.what)) {
      return ApplyTo(*waypoint, item);
    }
    if (auto* loiter = std::get_if<LoiterOptions>(&options_.what)) return ApplyTo(*loiter, item);
    auto* station = std::get_if<StationKeepOptions>(&options_.what);
    if (station == nullptr || item.key != "station_pt" || item.value != "present_position") {
      return false;
    }
    station->station_pt = position_m_;
    return true;
  }

  const std::string& problem() const { return problem_; }

 private:
  std::optional<Eigen::Vector2d> PointOf(const UpdateItem& item) {
    if (item.value == "present_position") return position_m_;
    const auto points = ParsePoints(item.value);
    const bool is_one =
        points.ok() && points->size() == 1 && points->front().cwiseAbs().maxCoeff() <= kFarthest_m;
    if (is_one) return points->front();
    problem_ = fmt::format("{} = {} is not a point; write it like 10,-20", item.key, item.value);
    return std::nullopt;
  }

  std::optional<double> NumberOf(const UpdateItem& item) {
    const auto number = NumberIn(item.value);
    if (number && std::abs(*number) <= kFarthest_m) return number;
    problem_ = fmt::format("{} = {} is not a number up to {}", item.key, item.value, kFarthest_m);
    return std::nullopt;
  }

  bool ApplyTo(WaypointOptions& options, const UpdateItem& item) {
    if (item.key != "point" && item.key != "newpt") return false;
    if (const auto point = PointOf(item)) {
      if (item.key == "point") options.points.clear();
      options.points.push_back(*point);
    }
    return true;
  }

  bool ApplyTo(LoiterOptions& options, const UpdateItem& item) {
    const bool has_polygon = !options.polygon.empty();
    const Eigen::Vector2d center = has_polygon ? Centroid(options.polygon) : Eigen::Vector2d(0, 0);
    Eigen::Vector2d moves(0, 0);
    double factor = 1;
    if (item.key == "center_assign") {
      if (const auto point = PointOf(item)) moves = *point - center;
    } else if (item.key == "xcenter_assign") {
      if (const auto x = NumberOf(item)) moves.x() = *x - center.x();
    } else if (item.key == "ycenter_assign") {
      if (const auto y = NumberOf(item)) moves.y() = *y - center.y();
    } else if (item.key == "mod_poly_rad" && has_polygon) {
      double radius_m = 0;
      for (const Eigen::Vector2d& corner : options.polygon) {
        radius_m = std::max(radius_m, (corner - center).norm());
      }
      if (const auto more_m = NumberOf(item)) {
        factor = std::max(kLeastRadius_m, radius_m + *more_m) / radius_m;
      }
    } else {
      return item.key == "mod_poly_rad";
    }
    if (!has_polygon) problem_ = item.key + ": there is no polygon to move";
    for (Eigen::Vector2d& corner : options.polygon) {
      corner = center + factor * (corner - center) + moves;
    }
    return true;
  }

  BehaviorOptions& options_;
  Eigen::Vector2d position_m_;
  std::string problem_;
};

}  // namespace

Result<BehaviorOptions> ReadBehaviorUpdate(const BehaviorOptions& options,
                                           std::span<const UpdateItem> items,
                                           const Eigen::Vector2d& position_m) {
  BehaviorOptions updated = options;
  std::vector<UpdateItem> of_the_file;
  std::vector<UpdateItem> modifying;
  for (const UpdateItem& item : items) {
    BehaviorOptions trial = options;
    const bool modifies = Modifier(trial, position_m).Apply(item);
    (modifies ? modifying : of_the_file).push_back(item);
  }
  Problems problems("", {});
  {
    UpdateReader reader(of_the_file, problems);
    reader.NoKey("name", "a text has one name: of the behavior that is meant");
    DescribeCommon(reader, updated);
    DescribeKindOf(reader, updated);
  }
  Modifier modifier(updated, position_m);
  for (const UpdateItem& item : modifying) {
    modifier.Apply(item);
    if (!modifier.problem().empty()) return Error{modifier.problem()};
  }
  if (problems.empty()) return updated;
  std::string first = problems.InOrder().front();
  const size_t begin = first.find(": ");
  return Error{begin == std::string::npos ? first : first.substr(begin + 2)};
}

}  // namespace shoal
