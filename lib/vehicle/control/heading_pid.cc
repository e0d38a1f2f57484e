#include "lib/vehicle/control/heading_pid.h"

#include <algorithm>

#include "lib/base/geometry/angles.h"

namespace shoal {

double HeadingPid::Update(double desired_deg, double heading_deg, double yaw_rate_degps,
                          double dt_s) {
  const double error_deg = Wrap180(Wrap180(desired_deg) - Wrap180(heading_deg));
  const double direct_pct = gains_.kp * error_deg - gains_.kd * yaw_rate_degps;
  const double integral_pct = std::clamp(integral_pct_ + gains_.ki * error_deg * dt_s,
                                         -gains_.integral_limit_pct, gains_.integral_limit_pct);
  const double output_pct = std::clamp(direct_pct + integral_pct, -100.0, 100.0);
  const bool pushes_further = (output_pct == 100 && integral_pct > integral_pct_) ||
                              (output_pct == -100 && integral_pct < integral_pct_);
  if (!pushes_further) integral_pct_ = integral_pct;
  return output_pct;
}

}  // namespace shoal
