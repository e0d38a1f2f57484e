// The path of a path_follow task: its points, or the parts that it is joined of.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/mission/file/path_text.h"
#include "lib/mission/file/task_fields.h"

namespace shoal {
namespace {

constexpr int kMaxPathPoints = 10'000;
constexpr size_t kMaxPathParts = 100;
constexpr double kDeepestPoint_m = 20'000;
constexpr std::array<std::pair<std::string_view, DepthRule>, 2> kDepthRules = {{
    {"next", DepthRule::kNext},
    {"slope", DepthRule::kSlope},
}};
constexpr NumberLimits kPartDepth = Between(0, kDeepestPoint_m);

bool IsInWorld(const Eigen::Vector3d& point_m) {
  return point_m.z() >= 0 && point_m.z() <= kDeepestPoint_m &&
         point_m.head<2>().cwiseAbs().maxCoeff() <= kFarthest_m;
}

/// Adds `offset_m`; refuses points that are then outside the world.
void PlacePoints(Fields& fields, std::vector<Eigen::Vector3d>& points_m,
                 const Eigen::Vector2d& offset_m) {
  for (Eigen::Vector3d& point_m : points_m) {
    point_m.head<2>() += offset_m;
    if (IsInWorld(point_m)) continue;
    fields.Refuse("points",
                  "points are [x, y, depth], with x and y within 1000 km of the origin "
                  "and depths from 0 to 20000 m");
    point_m.setZero();
  }
}

void DescribePathPoints(Fields& fields, std::vector<Eigen::Vector3d>& points_m) {
  fields.Require("points", "points = [[0, 0, 10], [100, 0, 20]]");
  fields.Triples("points", points_m, Between(-kFarthest_m, kFarthest_m), kMaxPathPoints);
  if (points_m.empty() && fields.Has("points", true)) {
    fields.Refuse("points", "points must hold at least one point, like [[100, 0, 20]]");
    points_m.emplace_back(Eigen::Vector3d::Zero());
  }
}

void RefuseDisorder(Fields& fields, std::string_view high_key, double high,
                    std::string_view low_key, double low) {
  if (low <= high) return;
  fields.Refuse(high_key, fmt::format("{} = {:g} must not be less than {} = {:g}", high_key, high,
                                      low_key, low));
}

void DescribePart(Fields& fields, PointsPart& part, const Eigen::Vector2d& offset_m) {
  DescribePathPoints(fields, part.points_m);
  PlacePoints(fields, part.points_m, offset_m);
}

void DescribeBegin(Fields& fields, std::optional<Eigen::Vector3d>& start_m,
                   const Eigen::Vector2d& offset_m) {
  if (!fields.Has("start", start_m.has_value())) return;
  Eigen::Vector3d point_m = start_m.value_or(Eigen::Vector3d::Zero());
  fields.Triple("start", point_m, Between(-kFarthest_m, kFarthest_m));
  point_m.head<2>() += offset_m;
  if (!IsInWorld(point_m)) {
    fields.Refuse("start",
                  "start must be [x, y, depth], with x and y within 1000 km of the origin and a "
                  "depth from 0 to 20000 m");
    point_m.setZero();
  }
  start_m = point_m;
}

void DescribePart(Fields& fields, RandomPart& part, const Eigen::Vector2d& offset_m) {
  RandomPathParams& bounds = part.bounds;
  fields.SmallInteger("num_points", bounds.num_waypoints, 1, kMaxPathPoints);
  DescribeBegin(fields, part.start_m, offset_m);
  if (fields.Has("start_heading_deg", part.start_heading_deg.has_value())) {
    double heading_deg = part.start_heading_deg.value_or(0);
    fields.Number("start_heading_deg", heading_deg, Between(-360, 360));
    part.start_heading_deg = heading_deg;
  }
  fields.Number("min_turn_deg", part.min_turn_deg, Between(-180, 180));
  fields.Number("max_turn_deg", part.max_turn_deg, Between(-180, 180));
  RefuseDisorder(fields, "max_turn_deg", part.max_turn_deg, "min_turn_deg", part.min_turn_deg);
  fields.Number("min_leg_m", bounds.min_leg_m, Between(0, 100'000));
  fields.Number("max_leg_m", bounds.max_leg_m, Between(0, 100'000));
  RefuseDisorder(fields, "max_leg_m", bounds.max_leg_m, "min_leg_m", bounds.min_leg_m);
  fields.Number("min_depth_m", bounds.min_depth_m, kPartDepth);
  fields.Number("max_depth_m", bounds.max_depth_m, kPartDepth);
  RefuseDisorder(fields, "max_depth_m", bounds.max_depth_m, "min_depth_m", bounds.min_depth_m);
}

void DescribePart(Fields& fields, LawnmowerPart& part, const Eigen::Vector2d& offset_m) {
  DescribePolygon(fields, part.area);
  for (Eigen::Vector2d& corner_m : part.area.polygon_m) Move(fields, "polygon", corner_m, offset_m);
  DescribeLanes(fields, part.area);
  DescribeRoute(fields, part.route);
  fields.Number("depth_m", part.depth_m, kPartDepth);
}

void DescribePart(Fields& fields, HelixPart& part, const Eigen::Vector2d& offset_m) {
  fields.Require("center", "center = [100, -50]");
  fields.Pair("center", part.center_m, kTaskPlace);
  Move(fields, "center", part.center_m, offset_m);
  fields.Number("radius_m", part.radius_m, Above(0, 100'000));
  fields.Number("turns", part.turns, Above(0, 1000));
  fields.Number("start_depth_m", part.start_depth_m, kPartDepth);
  fields.Number("end_depth_m", part.end_depth_m, kPartDepth);
  fields.Number("start_bearing_deg", part.start_bearing_deg, Between(-360, 360));
  fields.Flag("clockwise", part.clockwise);
  if (CountPoints(part) <= kMaxPathPoints) return;
  fields.Refuse("turns",
                fmt::format("turns = {:g} at radius_m = {:g} takes {:.0f} points; allowed: "
                            "at most {}",
                            part.turns, part.radius_m, CountPoints(part), kMaxPathPoints));
  part = HelixPart();
}

void DescribePart(Fields& fields, YoyoPart& part, const Eigen::Vector2d& offset_m) {
  DescribeBegin(fields, part.start_m, offset_m);
  fields.Require("to", "to = [400, 0]");
  fields.Pair("to", part.to_m, kTaskPlace);
  Move(fields, "to", part.to_m, offset_m);
  fields.Number("top_m", part.top_m, kPartDepth);
  fields.Number("bottom_m", part.bottom_m, kPartDepth);
  fields.Number("glide_deg", part.glide_deg, Between(1, 60));
  if (part.top_m < part.bottom_m) return;
  fields.Refuse("bottom_m", fmt::format("bottom_m = {:g} must be more than top_m = {:g}",
                                        part.bottom_m, part.top_m));
  part = YoyoPart();
}

/// `so_far` is the path that the part is put into.
void DescribePlace(Fields& fields, PathPart& part, const std::vector<Eigen::Vector3d>& so_far,
                   const PathStart& start) {
  if (fields.Has("insert_at", part.insert_at.has_value())) {
    int place = static_cast<int>(part.insert_at.value_or(0));
    fields.SmallInteger("insert_at", place, 0, kMaxPathPoints);
    part.insert_at = static_cast<size_t>(place);
    if (*part.insert_at > so_far.size()) {
      fields.Refuse("insert_at",
                    fmt::format("insert_at = {} is beyond the path so far, which has {} "
                                "points, the first of them 0: leave it out to go on at "
                                "the end",
                                place, so_far.size()));
    }
  }
  auto* yoyo = std::get_if<YoyoPart>(&part.what);
  if (yoyo == nullptr) return;
  const size_t place = std::min(part.insert_at.value_or(so_far.size()), so_far.size());
  const Eigen::Vector3d begin_m =
      yoyo->start_m.value_or(place > 0 ? so_far[place - 1] : start.position_m);
  const double num_points = CountPoints(*yoyo, begin_m);
  if (num_points <= kMaxPathPoints) return;
  fields.Refuse("to", fmt::format("the yo-yo to here has {:.0f} turning points; allowed: at most "
                                  "{}: glide less steeply, or between depths farther apart",
                                  num_points, kMaxPathPoints));
  yoyo->to_m = begin_m.head<2>();
}

void DescribeKindOf(Fields& fields, PathPart& part, const Eigen::Vector2d& offset_m) {
  const std::vector<PathPart> kinds = OnePartOfEachKind();
  std::vector<std::string_view> words;
  words.reserve(kinds.size());
  for (const PathPart& each : kinds) words.push_back(KindOf(each));
  std::string kind(fields.reading() ? "" : KindOf(part));
  fields.Require("kind", "kind = \"points\"");
  fields.Word("kind", kind, words);
  if (fields.reading()) {
    for (const PathPart& each : kinds) {
      if (kind == KindOf(each)) part = each;
    }
  }
  if (kind.empty()) {
    fields.SkipRest();  // Which keys are right depends on the kind.
    return;
  }
  std::visit([&](auto& what) { DescribePart(fields, what, offset_m); }, part.what);
}

void DescribeParts(Fields& fields, PathFollowTask& task, const Eigen::Vector2d& offset_m) {
  std::vector<PathPart> before;
  fields.List("path", task.parts, [&](Fields& table, PathPart& part) {
    DescribeKindOf(table, part, offset_m);
    DescribePlace(table, part, Join(before, task.start).path.points_m, task.start);
    before.push_back(part);
  });
  if (!fields.reading()) return;
  if (task.parts.empty() || task.parts.size() > kMaxPathParts) {
    fields.Refuse("path", fmt::format("a path is joined of 1 to {} parts, like path = [{{kind = "
                                      "\"points\", points = [[100, 0, 20]]}}]",
                                      kMaxPathParts));
  }
}

}  // namespace

void DescribePath(Fields& fields, PathFollowTask& task, const StartPose& start) {
  if (!fields.reading()) fields.Note("The path: " + PathText(task));
  if (fields.reading()) {
    task.start = {.position_m = {start.x_m, start.y_m, start.depth_m},
                  .heading_rad = DegToRad(start.heading_deg)};
  }
  const bool has_parts = fields.Has("path", !task.parts.empty());
  if (!has_parts) DescribePathPoints(fields, task.points_m);
  const Eigen::Vector2d offset_m = DescribeFrame(fields, start);
  if (has_parts) {
    if (fields.Has("points", false)) {
      fields.Refuse("points",
                    "a path_follow has points or a path: write these as a part "
                    "{kind = \"points\", points = ...} of the path");
    }
    DescribeParts(fields, task, offset_m);
    if (fields.reading()) task.depth_rule = DepthRule::kSlope;
  }
  PlacePoints(fields, task.points_m, offset_m);
  fields.Number("turn_radius_m", task.turn_radius_m, Between(0, 10'000));
  fields.Flag("approach", task.approach);
  fields.Choice("depth_rule", task.depth_rule, kDepthRules);
}

}  // namespace shoal
