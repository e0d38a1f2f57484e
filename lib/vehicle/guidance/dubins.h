// The shortest way from one pose to another for a vessel that cannot turn more tightly than a
// radius: arc, straight line and arc, or three arcs (Dubins 1957).
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace shoal {

/// Where a vessel is and where it heads.
struct TurnPose {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< x East, y North.
  double heading_rad = 0;                                ///< Clockwise from North.
};

/// One of the three parts of a way: an arc, or a straight line.
struct DubinsPart {
  int turn = 0;         ///< 1: to starboard, -1: to port, 0: straight.
  double length_m = 0;  ///< >= 0.
};

struct DubinsWay {
  TurnPose from;
  double radius_m = 0;
  std::array<DubinsPart, 3> parts;

  double Length_m() const;
};

/// Returns the shortest of the six ways of Dubins, by the formulas of Shkel and Lumelsky (2001).
/// @pre radius_m > 0, poses are finite
[[nodiscard]] DubinsWay ShortestWay(const TurnPose& from, const TurnPose& to, double radius_m);

/// Returns points along the way without its first, with its last; on arcs one in every 22.5 deg or
/// less, so that the lines between them miss the arc by less than 2 % of its radius.
[[nodiscard]] std::vector<Eigen::Vector2d> PointsAlong(const DubinsWay& way);

}  // namespace shoal
