#include "apps/helm/remus100_ahead.h"

#include <algorithm>
#include <cmath>

#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kMaxRate = 25;  // As the model has it, in m/s and rad/s.

}  // namespace

Remus100State Remus100Ahead::Predict(const nav_t& nav, double dt_s) {
  Remus100State state;
  state.eta << nav.x_m, nav.y_m, nav.z_m, WrapPi(-DegToRad(nav.roll_deg)),
      std::clamp(DegToRad(nav.pitch_deg), -kPi / 2, kPi / 2),
      WrapPi(PsiFromHeading(DegToRad(nav.heading_deg)));
  state.nu << nav.surge_mps, -nav.sway_mps, nav.heave_mps, -DegToRad(nav.roll_rate_degps),
      DegToRad(nav.pitch_rate_degps), -DegToRad(nav.yaw_rate_degps);
  state.nu = state.nu.cwiseMax(-kMaxRate).cwiseMin(kMaxRate);
  state.actuators = actuators_;
  // A step that fits up to rounding is not cut in two.
  const double num_steps = std::max(1.0, std::ceil(dt_s / model_step_s_ - 1e-9));
  for (int i = 0; i < static_cast<int>(num_steps); ++i) {
    state = Step(auv_, state, command_, {}, dt_s / num_steps);
  }
  actuators_ = state.actuators;
  return state;
}

}  // namespace shoal
