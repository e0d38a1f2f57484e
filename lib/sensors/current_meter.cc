#include "lib/sensors/current_meter.h"

namespace shoal {

Eigen::Vector2d MeasureCurrent(const CurrentMeter& meter, const Current& current, double time_s,
                               int64_t number) {
  Eigen::Vector2d velocity_mps = Velocity(current.At(time_s));
  if (meter.noise.sigma == 0) return velocity_mps;
  Stream draws = meter.noise.Measurement(number);
  const double east_mps = draws.Normal();
  const double north_mps = draws.Normal();
  return velocity_mps + meter.noise.sigma * Eigen::Vector2d(east_mps, north_mps);
}

}  // namespace shoal
