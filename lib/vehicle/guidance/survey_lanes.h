// The lanes of a survey: parallel lines over a polygon, shared out among vehicles, and one
// vehicle's way along its own.
//
//   const std::vector<SurveyLane> lanes = LanesOver({.polygon_m = corners_m, .lane_spacing_m =
//   20}); const std::vector<Eigen::Vector2d> points_m =
//       PathAlong(ShareOf(lanes, {.place = 1, .members = 3}), {.turn_radius_m = 8});
//
// Lanes are counted from port to starboard of lane_angle_deg: with 0, from West to East.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/base/geometry/leg.h"

namespace shoal {

/// How far a lane reaches.
enum class LaneEnds {
  /// As far as the polygon does within half a spacing to either side: every point of the polygon
  /// lies within half a spacing of a lane. Where an edge is slanted, the lane leaves the polygon
  /// there, and never by more than half a spacing.
  kCover,
  /// To the edges of the polygon. At a slanted edge a corner is left uncovered.
  kInside,
};

/// What is surveyed, and in which lines.
struct SurveyArea {
  std::vector<Eigen::Vector2d> polygon_m;  ///< x East, y North; see PolygonProblem.
  double lane_spacing_m = 20;              ///< At most; > 0. Lanes are spread evenly.
  /// Compass direction; absent: that of the longest edge, in [0, 180).
  std::optional<double> lane_angle_deg = {};
  LaneEnds lane_ends = LaneEnds::kCover;

  bool operator==(const SurveyArea&) const = default;
};

/// One line over the polygon. A concave polygon may break it into several parts.
struct SurveyLane {
  std::vector<Leg> parts;  ///< In the direction of lane_angle_deg; at least one.
};

/// Which part of a survey is one vehicle's: that of member `place`, from 0, of `members`.
struct SurveyShare {
  size_t place = 0;
  size_t members = 1;  ///< >= 1.

  bool operator==(const SurveyShare&) const = default;
};

/// The end of the first or the last lane at which a survey begins: of these four points the
/// nearest, or the one that lies farthest to that side.
enum class SurveyEntry { kNearest, kNorthWest, kNorthEast, kSouthEast, kSouthWest };

/// How a vehicle passes its lanes.
struct SurveyRoute {
  SurveyEntry entry = SurveyEntry::kNearest;
  Eigen::Vector2d start_m = Eigen::Vector2d::Zero();  ///< kNearest: to here.
  double turn_radius_m = 0;                           ///< 0: straight from lane to lane.
  double overrun_m = 0;  ///< This much farther at both ends of each lane; >= 0.

  bool operator==(const SurveyRoute&) const = default;
};

/// Returns why `polygon_m` is not a simple polygon, or an empty text if it is: it has fewer than
/// three corners, two of them in one place, edges that meet elsewhere than at their ends, or no
/// area. A simple polygon may be concave, and its corners may be listed clockwise or
/// counterclockwise.
[[nodiscard]] std::string PolygonProblem(std::span<const Eigen::Vector2d> polygon_m);

/// Returns the area that a simple polygon encloses.
[[nodiscard]] double AreaOf_m2(std::span<const Eigen::Vector2d> polygon_m);

/// Returns true inside a simple polygon.
[[nodiscard]] bool IsInside(std::span<const Eigen::Vector2d> polygon_m,
                            const Eigen::Vector2d& point_m);

/// Returns how many lanes there are: as few as the spacing allows. It can be too large for
/// LanesOver. @pre PolygonProblem is empty
[[nodiscard]] double CountLanes(const SurveyArea& area);

/// Returns all lanes from port to starboard, the outer ones half a spacing from the polygon's
/// farthest points. Nothing where there is no polygon.
/// @pre PolygonProblem is empty, or there are no corners; CountLanes is a million at most
[[nodiscard]] std::vector<SurveyLane> LanesOver(const SurveyArea& area);

/// Returns the lanes of one member: neighbours, of about equal length for all, every lane
/// for exactly one. Each has one lane at least where there are enough.
[[nodiscard]] std::span<const SurveyLane> ShareOf(std::span<const SurveyLane> lanes,
                                                  const SurveyShare& share);

/// Returns the points that are passed one after the other: the lanes in turn, every second one
/// backward. Parts of a lane are connected by a straight line, one lane and the next by the
/// shortest way with no turn tighter than the radius (lib/vehicle/guidance/dubins.h): half a
/// circle, or, where the spacing is less than two radii, a bulb.
[[nodiscard]] std::vector<Eigen::Vector2d> PathAlong(std::span<const SurveyLane> lanes,
                                                     const SurveyRoute& route);

}  // namespace shoal
