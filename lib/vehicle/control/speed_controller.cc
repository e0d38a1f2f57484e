#include "lib/vehicle/control/speed_controller.h"

#include <algorithm>

namespace shoal {

namespace {

// Far beyond any vessel: keeps sums and products finite.
constexpr double kMaxSpeed_mps = 1e6;
constexpr double kMaxThrust_pct = 1e6;

}  // namespace

double SpeedController::Update(double desired_mps, double feed_forward_pct, double measured_mps,
                               double dt_s) {
  if (desired_mps <= 0) {
    Reset();
    return 0;
  }
  desired_mps = std::min(desired_mps, kMaxSpeed_mps);
  measured_mps = std::clamp(measured_mps, -kMaxSpeed_mps, kMaxSpeed_mps);
  feed_forward_pct = std::clamp(feed_forward_pct, -kMaxThrust_pct, kMaxThrust_pct);
  const double from_mps = reference_mps_.value_or(measured_mps);
  const double max_change_mps = gains_.acceleration_mps2 * dt_s;
  reference_mps_ = from_mps + std::clamp(desired_mps - from_mps, -max_change_mps, max_change_mps);

  const double error_mps = *reference_mps_ - measured_mps;
  const double integral_pct = std::clamp(integral_pct_ + gains_.ki * error_mps * dt_s,
                                         -gains_.integral_limit_pct, gains_.integral_limit_pct);
  const double wanted_pct = feed_forward_pct + gains_.kp * error_mps + integral_pct;
  const double output_pct = std::clamp(wanted_pct, 0.0, 100.0);
  const bool pushes_further = (wanted_pct > 100 && integral_pct > integral_pct_) ||
                              (wanted_pct < 0 && integral_pct < integral_pct_);
  if (!pushes_further) integral_pct_ = integral_pct;
  return output_pct;
}

void SpeedController::Reset() {
  integral_pct_ = 0;
  reference_mps_.reset();
}

}  // namespace shoal
