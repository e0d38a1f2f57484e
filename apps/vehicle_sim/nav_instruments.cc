#include "apps/vehicle_sim/nav_instruments.h"

#include <algorithm>

#include "lib/base/geometry/angles.h"

namespace shoal {

NavInstruments::NavInstruments(const SensorOptions& options, uint64_t seed,
                               std::string_view vehicle)
    : options_(options), key_(StreamKey(seed, "nav").With(vehicle)) {}

nav_t NavInstruments::Measure(const nav_t& truth, const LocalFrame& frame) const {
  // One number after the other from one stream: the order here is part of what a seed means.
  Stream draws(key_.With(truth.utime));
  const auto noise = [&](double sigma) { return sigma * draws.Normal(); };
  nav_t nav = truth;
  nav.x_m += noise(options_.position_noise_m);
  nav.y_m += noise(options_.position_noise_m);
  nav.z_m += noise(options_.depth_noise_m);
  nav.roll_deg += noise(options_.attitude_noise_deg);
  nav.pitch_deg += noise(options_.attitude_noise_deg);
  nav.heading_deg = Wrap360(nav.heading_deg + noise(options_.attitude_noise_deg));
  nav.roll_rate_degps += noise(options_.rate_noise_degps);
  nav.pitch_rate_degps += noise(options_.rate_noise_degps);
  nav.yaw_rate_degps += noise(options_.rate_noise_degps);
  nav.surge_mps += noise(options_.speed_noise_mps);
  nav.sway_mps += noise(options_.speed_noise_mps);
  nav.heave_mps += noise(options_.speed_noise_mps);
  nav.speed_mps += noise(options_.speed_noise_mps);
  Eigen::Vector2d over_ground_mps =
      truth.speed_over_ground_mps * UnitVector(DegToRad(truth.course_over_ground_deg));
  over_ground_mps.x() += noise(options_.speed_noise_mps);
  over_ground_mps.y() += noise(options_.speed_noise_mps);
  nav.descent_mps += noise(options_.speed_noise_mps);
  const double altitude_noise_m = noise(options_.altitude_noise_m);

  nav.speed_over_ground_mps = over_ground_mps.norm();
  nav.course_over_ground_deg = nav.speed_over_ground_mps > 0
                                   ? Wrap360(RadToDeg(HeadingOf(over_ground_mps)))
                                   : nav.heading_deg;
  const bool sees_floor = truth.altitude_m >= 0 && truth.altitude_m <= options_.altimeter_range_m;
  nav.altitude_m = sees_floor ? std::max(0.0, truth.altitude_m + altitude_noise_m) : -1;
  const GeoPoint geo = frame.ToGeo({nav.x_m, nav.y_m});
  nav.lat_deg = geo.lat_deg;
  nav.lon_deg = geo.lon_deg;
  return nav;
}

}  // namespace shoal
