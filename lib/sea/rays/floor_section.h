// The sea floor below the straight way between two places, as the bottom of a section.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "lib/sea/ocean/sea_floor.h"
#include "lib/sea/rays/ray_scene.h"

namespace shoal {

/// Returns the floor's depths from `from_m` (range 0) to `to_m`, at `num_points` evenly spaced
/// places, straight in between. The section depends on the two places alone: turned or moved
/// together with the floor, they give the same.
/// @pre num_points >= 2, finite places that differ
[[nodiscard]] std::vector<BoundaryPoint> FloorSection(const SeaFloor& floor,
                                                      const Eigen::Vector2d& from_m,
                                                      const Eigen::Vector2d& to_m, int num_points);

}  // namespace shoal
