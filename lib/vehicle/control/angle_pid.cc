#include "lib/vehicle/control/angle_pid.h"

#include <algorithm>

#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

// Beyond anything that control of a vehicle sees: keeps sums finite.
constexpr double kMaxIntegral = 1e9;
constexpr double kMaxDepthError_m = 1e6;
constexpr double kMaxRate_radps = 1e6;

struct PiOutput {
  double value = 0;
  double integral = 0;
};

/// One step of kp e + ki I + `more`, limited.
PiOutput LimitedPi(double kp, double ki, double integral, double error, double more, double limit,
                   double dt_s) {
  const double wanted = kp * error + ki * integral + more;
  const double value = std::clamp(wanted, -limit, limit);
  const bool is_limited = value != wanted;
  if (dt_s <= 0) return {.value = value, .integral = integral};
  integral += is_limited && ki != 0 ? (value - wanted) / ki : error * dt_s;
  return {.value = value, .integral = std::clamp(integral, -kMaxIntegral, kMaxIntegral)};
}

}  // namespace

double AnglePid::Update(const AnglePidGains& gains, double angle_rad, double desired_rad,
                        double rate_radps, double dt_s) {
  const double error_rad = WrapPi(WrapPi(angle_rad) - WrapPi(desired_rad));
  const double bounded_rate_radps = std::clamp(rate_radps, -kMaxRate_radps, kMaxRate_radps);
  const PiOutput output = LimitedPi(gains.kp, gains.ki, integral_rads, error_rad,
                                    gains.kd * bounded_rate_radps, gains.max_output_rad, dt_s);
  integral_rads = output.integral;
  return output.value;
}

double DepthPi::Update(const DepthPiGains& gains, double z_m, double desired_z_m, double dt_s,
                       double feed_forward_rad) {
  const double error_m = std::clamp(z_m - desired_z_m, -kMaxDepthError_m, kMaxDepthError_m);
  const PiOutput output = LimitedPi(gains.kp, gains.ki, integral_ms, error_m, feed_forward_rad,
                                    gains.max_pitch_rad, dt_s);
  integral_ms = output.integral;
  return output.value;
}

}  // namespace shoal
