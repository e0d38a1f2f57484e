#include "lib/vehicle/navigation/velocity_sensors.h"

namespace shoal {

bool HasBottomLock(const Dvl& dvl, std::optional<double> altitude_m) {
  return altitude_m && *altitude_m >= dvl.min_altitude_m && *altitude_m <= dvl.max_altitude_m;
}

std::optional<Eigen::Vector2d> ReadDvl(const Dvl& dvl, const Eigen::Vector2d& over_ground_mps,
                                       std::optional<double> altitude_m, Stream* draws) {
  const bool is_lost = draws->Uniform() < dvl.dropout;
  const double forward = draws->Normal();
  const double starboard = draws->Normal();
  if (is_lost || !HasBottomLock(dvl, altitude_m)) return std::nullopt;
  return (1 + dvl.scale_error) * over_ground_mps +
         dvl.noise_mps * Eigen::Vector2d(forward, starboard);
}

double ReadSpeedLog(const SpeedLog& log, double forward_mps, Stream* draws) {
  return forward_mps + log.noise_mps * draws->Normal();
}

double ReadDepth(const DepthSensor& sensor, double depth_m, Stream* draws) {
  return depth_m + sensor.bias_m + sensor.noise_m * draws->Normal();
}

}  // namespace shoal
