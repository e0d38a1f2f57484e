#include "lib/sensors/altimeter.h"

#include <algorithm>

namespace shoal {

double DepthBelow(const SeaFloor& floor, const Eigen::Vector3d& position_m) {
  return std::max(0.0, floor.DepthAt(position_m.head<2>()) - position_m.z());
}

std::optional<double> MeasureAltitude(const Altimeter& altimeter, const SeaFloor& floor,
                                      const Eigen::Vector3d& position_m, int64_t number) {
  const double altitude_m = DepthBelow(floor, position_m);
  if (!(altitude_m <= altimeter.max_range_m)) return std::nullopt;
  if (altimeter.noise.sigma == 0) return altitude_m;
  const double error_m = altimeter.noise.sigma * altimeter.noise.Measurement(number).Normal();
  return std::clamp(altitude_m + error_m, 0.0, altimeter.max_range_m);
}

}  // namespace shoal
