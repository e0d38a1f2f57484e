#include "lib/vehicle/guidance/alos.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

AlosStep StepAlos(const AlosParams& params, double path_angle_rad, double cross_track_m,
                  double crab_rad, double dt_s) {
  const double lookahead_m = params.lookahead_m;
  const double error_m = Plausible(cross_track_m);
  const double rate_radps = params.crab_gain * lookahead_m * error_m / Hypot(lookahead_m, error_m);
  const double course_rad = Plausible(path_angle_rad) - Plausible(crab_rad);
  return {.heading_rad = WrapPi(course_rad - Atan2(error_m, lookahead_m)),
          .crab_rad = Plausible(crab_rad) + rate_radps * Plausible(dt_s)};
}

double Alos::Update(double path_angle_rad, double cross_track_m, double dt_s) {
  const AlosStep step = StepAlos(params_, path_angle_rad, cross_track_m, crab_rad_, dt_s);
  if (std::abs(cross_track_m) <= params_.lookahead_m) {
    crab_rad_ = std::clamp(step.crab_rad, -kMaxCrab_rad, kMaxCrab_rad);
  }
  return step.heading_rad;
}

void Alos::TurnBy(double turn_rad) { crab_rad_ *= Cos(turn_rad); }

}  // namespace shoal
