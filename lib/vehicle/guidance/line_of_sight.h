// The direction from one vehicle to another, defined also where they coincide.
#pragma once

#include "lib/vehicle/guidance/surroundings.h"

namespace shoal {

struct LineOfSight {
  Eigen::Vector3d away = Eigen::Vector3d::UnitX();  ///< Unit vector from `other` to `own`.
  double range_m = 0;
};

/// Returns the direction in which `own` leaves `other`. Closer than a micrometre there is none: the
/// one with the greater id then goes East, the other West, so that they part.
/// @pre positions finite
[[nodiscard]] LineOfSight SightFrom(const Neighbour& other, const Neighbour& own);

}  // namespace shoal
