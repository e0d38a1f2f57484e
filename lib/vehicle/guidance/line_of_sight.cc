#include "lib/vehicle/guidance/line_of_sight.h"

#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

LineOfSight SightFrom(const Neighbour& other, const Neighbour& own) {
  constexpr double kCoincident_m = 1e-6;
  const Eigen::Vector3d offset_m = Plausible(own.position_m) - Plausible(other.position_m);
  const double range_m = offset_m.norm();
  if (range_m < kCoincident_m) {
    const double side = own.id >= other.id ? 1.0 : -1.0;
    return {.away = side * Eigen::Vector3d::UnitX(), .range_m = range_m};
  }
  return {.away = offset_m / range_m, .range_m = range_m};
}

}  // namespace shoal
