// What a path is joined of: points, and shapes that are made into points.
//
//   JoinedPath joined = Join({{PointsPart{{{0, 0, 10}}}}, {HelixPart{.center_m = {200, 0}}}}, {});
//   joined = RoundCorners(joined, 25);
//
// A part that names no place of its own begins where the path before it ends.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/vehicle/guidance/survey_lanes.h"
#include "lib/vehicle/guidance/waypoint_path.h"

namespace shoal {

/// Points as they are.
struct PointsPart {
  static constexpr std::string_view kKind = "points";

  std::vector<Eigen::Vector3d> points_m;  ///< x East, y North, z down; at least one.

  bool operator==(const PointsPart&) const = default;
};

/// Random legs: MuNet's generateRandomPath.
struct RandomPart {
  static constexpr std::string_view kKind = "random";

  RandomPathParams bounds = {};  ///< But for where it starts, and how it turns.
  double min_turn_deg = -90;     ///< From leg to leg, to starboard positive.
  double max_turn_deg = 90;
  std::optional<Eigen::Vector3d> start_m = {};   ///< Absent: where the path before it ends.
  std::optional<double> start_heading_deg = {};  ///< Absent: the course on which it ends.
  uint64_t seed = 0;                             ///< Follows from the mission's.

  bool operator==(const RandomPart&) const = default;
};

/// The lanes of a survey, at one depth.
struct LawnmowerPart {
  static constexpr std::string_view kKind = "lawnmower";

  SurveyArea area;
  SurveyRoute route;  ///< But for start_m: the nearest entry is that to the path before it.
  double depth_m = 10;

  bool operator==(const LawnmowerPart&) const = default;
};

/// Round a centre, down or up.
struct HelixPart {
  static constexpr std::string_view kKind = "helix";

  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double radius_m = 50;  ///< > 0.
  double turns = 3;      ///< > 0; need not be whole.
  double start_depth_m = 5;
  double end_depth_m = 40;
  double start_bearing_deg = 0;  ///< From the centre to where it begins.
  bool clockwise = true;         ///< Seen from above.

  bool operator==(const HelixPart&) const = default;
};

/// Down and up between two depths on a straight line.
struct YoyoPart {
  static constexpr std::string_view kKind = "yoyo";

  std::optional<Eigen::Vector3d> start_m = {};  ///< Absent: where the path before it ends.
  Eigen::Vector2d to_m = Eigen::Vector2d::Zero();
  double top_m = 5;       ///< Depth where it turns down.
  double bottom_m = 40;   ///< > top_m.
  double glide_deg = 15;  ///< Of the path, from the horizontal; in (0, 90).

  bool operator==(const YoyoPart&) const = default;
};

struct PathPart {
  std::variant<PointsPart, RandomPart, LawnmowerPart, HelixPart, YoyoPart> what;
  /// Before this point of the path so far, counted from 0; absent: at its end.
  std::optional<size_t> insert_at = {};

  bool operator==(const PathPart&) const = default;
};

/// Where a vehicle begins.
struct PathStart {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double heading_rad = 0;

  bool operator==(const PathStart&) const = default;
};

struct JoinedPath {
  WaypointPath path = {};
  bool has_curves = false;  ///< Most points only shape a curve.

  bool operator==(const JoinedPath&) const = default;
};

/// Returns one part of each kind with its defaults.
[[nodiscard]] std::vector<PathPart> OnePartOfEachKind();
[[nodiscard]] std::string_view KindOf(const PathPart& part);

/// Returns the parts joined in order. Of two equal points at a joint one is left out. An
/// `insert_at` beyond the path counts as its end.
[[nodiscard]] JoinedPath Join(const std::vector<PathPart>& parts, const PathStart& start);

/// Returns how many points a helix or yo-yo has; too many must not be joined.
[[nodiscard]] double CountPoints(const HelixPart& part);
[[nodiscard]] double CountPoints(const YoyoPart& part, const Eigen::Vector3d& start_m);

/// Returns the path with an arc of `radius_m` in place of each waypoint where it turns by more than
/// 22.5 deg: it leaves a leg R tan(turn / 2) before the waypoint and passes it at a distance of
/// R (1 / cos(turn / 2) - 1). Where half of a leg is shorter than that, the arc is as wide as it
/// allows. First and last waypoint stay, and those where it turns right round. An arc has the
/// waypoint's depth. @pre radius_m > 0
[[nodiscard]] JoinedPath RoundCorners(const JoinedPath& joined, double radius_m);

}  // namespace shoal
