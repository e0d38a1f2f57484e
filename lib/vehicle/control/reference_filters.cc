#include "lib/vehicle/control/reference_filters.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kMaxReferenceRate_radps = 1e3;
constexpr double kMaxRpm = 1e6;

}  // namespace

void HeadingObserver::Update(double gain_hz, double psi_ref_rad, double dt_s) {
  // xi lags psi_d by r_d; the filter's time constant is that of Fossen's pole placement.
  const double time_s = 1 / (gain_hz + 2 * std::sqrt(gain_hz) + 1);
  const double keep = Exp(-dt_s / time_s);
  const double rate_radps =
      std::clamp(r_d_radps, -kMaxReferenceRate_radps, kMaxReferenceRate_radps);
  const double xi = psi_d_rad - rate_radps;
  const double next_psi_d =
      psi_d_rad + dt_s * (rate_radps + gain_hz * WrapPi(WrapPi(psi_ref_rad) - WrapPi(psi_d_rad)));
  r_d_radps = next_psi_d - (keep * xi + (1 - keep) * next_psi_d);
  psi_d_rad = WrapPi(next_psi_d);
}

double LimitDepth(double z_m, const DepthLimits& limits, double seabed_z_m) {
  const double deepest_m = std::min(limits.max_z_m, seabed_z_m - limits.seabed_clearance_m);
  return std::max(0.0, std::min(z_m, deepest_m));
}

double DepthFilter::Update(const DepthFilterParams& params, double z_m, double dt_s) {
  const double steps = params.settles_per_step ? 1 : dt_s / params.time_s;
  const double keep = Exp(-steps);
  z_d_m = keep * z_d_m + (1 - keep) * z_m;
  return z_d_m;
}

double RampRpm(double rpm, double setpoint_rpm, double max_rate_rpmps, double dt_s) {
  const double from_rpm = std::clamp(rpm, -kMaxRpm, kMaxRpm);
  const double to_rpm = std::clamp(setpoint_rpm, -kMaxRpm, kMaxRpm);
  const double max_change_rpm = max_rate_rpmps * dt_s;
  return from_rpm + std::clamp(to_rpm - from_rpm, -max_change_rpm, max_change_rpm);
}

}  // namespace shoal
