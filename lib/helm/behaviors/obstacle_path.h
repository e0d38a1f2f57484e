// How far the path of a vessel that turns and then goes straight on stays clear of an obstacle.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "lib/helm/colregs/encounter_geometry.h"

namespace shoal {

struct TurnThenStraight {
  double turn_radius_m = 0;  ///< 0: turns on the spot.
  double reach_m = 100;      ///< Length of the straight part.
};

/// Returns, for each of the 360 courses, the least distance, m, between the path and a convex
/// polygon; 0 where it goes through. The vessel turns the shorter way, and by 180 degrees the
/// better.
/// @pre at least three corners
[[nodiscard]] std::vector<double> ClearanceOfCourses(const VesselMotion& own,
                                                     const TurnThenStraight& path,
                                                     const std::vector<Eigen::Vector2d>& polygon_m);

}  // namespace shoal
