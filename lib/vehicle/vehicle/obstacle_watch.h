// Finds where vehicles hit obstacles that do not move, each hit once.
//
//   ObstacleWatch watch({3, 1.6}, polygons_m);       // lengths, metres
//   for (const ObstacleHit& hit : watch.Look(seen, positions_m)) ...
//
// An obstacle reaches from the surface to the floor. A vehicle hits it where its centre is nearer
// to it than half of its length, or inside.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "lib/base/geometry/convex_polygon.h"

namespace shoal {

/// A vehicle that has just hit an obstacle; both are places in their lists.
struct ObstacleHit {
  uint32_t vehicle = 0;
  uint32_t obstacle = 0;
  double distance_m = 0;  ///< From its centre to the border; negative: inside.
  double allowed_m = 0;   ///< Half of its length; > distance_m.
};

/// Returns the place of the obstacle that a vehicle of this length at `position_m` touches, the
/// first of several; -1: none. Positions that are not finite touch nothing.
[[nodiscard]] int TouchedObstacle(std::span<const Polygon> polygons_m,
                                  const Eigen::Vector2d& position_m, double length_m);

class ObstacleWatch {
 public:
  /// @pre lengths >= 0; polygons convex
  ObstacleWatch(std::vector<double> lengths_m, std::vector<Polygon> polygons_m);

  /// Takes the positions of the vehicles in `seen`, and returns the hits that begin there, in order
  /// of the vehicles: not where the same two have touched before and were never farther apart than
  /// the vehicle's length since. Valid until the next call. @pre `positions_m` has one finite
  /// position per length
  [[nodiscard]] std::span<const ObstacleHit> Look(std::span<const uint32_t> seen,
                                                  std::span<const Eigen::Vector3d> positions_m);

 private:
  std::vector<double> lengths_m_;
  std::vector<Polygon> polygons_m_;
  std::set<std::pair<uint32_t, uint32_t>> touching_;  ///< Of hits that are not over.
  std::vector<ObstacleHit> found_;
};

}  // namespace shoal
