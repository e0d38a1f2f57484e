#include "lib/vehicle/navigation/gyro.h"

#include <cmath>

#include "lib/base/check/check.h"

namespace shoal {

double GyroUnit::Read(double turn_rad, double dt_s, int64_t utime) {
  SHOAL_CHECK(dt_s > 0, "dt_s > 0");
  Stream draws(key_.With(utime));
  const double root_dt = std::sqrt(dt_s);
  const double noise_radps = gyro_.noise_rad_per_rts / root_dt * draws.Normal();
  const double rate_radps = turn_rad / dt_s + bias_radps_ + noise_radps;
  bias_radps_ += gyro_.bias_walk_radps_per_rts * root_dt * draws.Normal();
  return rate_radps;
}

}  // namespace shoal
