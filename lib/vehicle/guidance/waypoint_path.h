// A path as a list of waypoints in three dimensions, and what can be estimated of it beforehand.
//
//   WaypointPath path{{{0, 0, 10}, {500, 0, 20}, {500, 500, 20}}};
//   double time_s = EstimateTime_s(path, 2.0);
//
// x East, y North, z down; psi from East toward North.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/base/random/stream.h"

namespace shoal {

struct WaypointPath {
  std::vector<Eigen::Vector3d> points_m = {};

  bool operator==(const WaypointPath&) const = default;
};

/// Returns the path with `point_m` before the waypoint `index`; index = size appends.
/// @pre index <= size
[[nodiscard]] WaypointPath Insert(WaypointPath path, size_t index, const Eigen::Vector3d& point_m);

/// Returns the length of each leg in three dimensions: one less than there are waypoints, none for
/// an empty path.
[[nodiscard]] std::vector<double> LegLengths_m(const WaypointPath& path);

/// Returns psi of each leg, (-pi, pi]. A leg without horizontal length has that of the leg before,
/// or if there is none the first that a later leg has; 0 if no leg has one.
[[nodiscard]] std::vector<double> LegPsis_rad(const WaypointPath& path);

[[nodiscard]] double TotalLength_m(const WaypointPath& path);

/// Returns the time to travel the path; `margin` allows for turns and currents.
/// @pre speed_mps > 0, margin > 0
[[nodiscard]] double EstimateTime_s(const WaypointPath& path, double speed_mps = 2.0,
                                    double margin = 1.2);

/// A square in the horizontal plane, sides along the axes.
struct BoundingSquare {
  double side_m = 0;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< Where (0, 0) is from its SW corner.
};

/// Returns the square that holds the path with `padding_m` around it; its side is the larger
/// extent, rounded up to a metre, and twice the padding. An empty path counts as one at (0, 0).
/// @pre padding_m >= 0
[[nodiscard]] BoundingSquare EstimateArea(const WaypointPath& path, double padding_m = 300);

/// Bounds of a random path; every draw is uniform between its two bounds.
/// @pre min <= max, everything finite
struct RandomPathParams {
  int num_waypoints = 1;  ///< After the start. >= 0.
  Eigen::Vector3d start_m = Eigen::Vector3d::Zero();
  double start_psi_rad = 0;        ///< The first leg's turn counts from here.
  double min_turn_rad = -kPi / 2;  ///< From one leg to the next, toward North positive.
  double max_turn_rad = kPi / 2;
  double min_leg_m = 100;  ///< Horizontal length of a leg. >= 0.
  double max_leg_m = 200;
  double min_depth_m = 0;  ///< Of each waypoint but the start.
  double max_depth_m = 100;

  bool operator==(const RandomPathParams&) const = default;
};

/// Returns the start and `num_waypoints` more. The same stream gives the same path.
[[nodiscard]] WaypointPath RandomPath(const RandomPathParams& params, Stream& stream);

}  // namespace shoal
