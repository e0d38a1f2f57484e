#include "lib/guidance/alos.h"

#include <algorithm>
#include <cmath>

#include "lib/geometry/angles.h"

namespace shoal {

double Alos::Update(double path_angle_rad, double cross_track_m, double dt_s) {
  const double lookahead_m = params_.lookahead_m;
  const double heading_rad =
      WrapPi(path_angle_rad - crab_rad_ - std::atan2(cross_track_m, lookahead_m));
  if (std::abs(cross_track_m) <= lookahead_m) {
    const double rate_radps =
        params_.crab_gain * lookahead_m * cross_track_m / std::hypot(lookahead_m, cross_track_m);
    crab_rad_ = std::clamp(crab_rad_ + rate_radps * dt_s, -kMaxCrab_rad, kMaxCrab_rad);
  }
  return heading_rad;
}

void Alos::TurnBy(double turn_rad) { crab_rad_ *= std::cos(turn_rad); }

}  // namespace shoal
