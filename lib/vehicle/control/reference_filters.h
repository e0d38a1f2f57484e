// What is between a guidance law and an autopilot: commands made smooth and safe.
//
//   DepthFilter depth{.z_d_m = z};
//   double z_d = depth.Update({}, LimitDepth(z_wpt, limits, seabed_z), dt_s);
//   HeadingObserver heading{.psi_d_rad = psi};
//   heading.Update(0.5, psi_ref, dt_s);    // then heading.psi_d_rad and heading.r_d_radps
#pragma once

namespace shoal {

/// Follows the heading of a line-of-sight law and estimates its rate. Fossen (2021), Handbook of
/// Marine Craft Hydrodynamics and Motion Control, section 12.3; as LOSobserver in the Marine
/// Systems Simulator.
struct HeadingObserver {
  double psi_d_rad = 0;  ///< In (-pi, pi].
  double r_d_radps = 0;

  /// Moves the estimate toward `psi_ref_rad` the shorter way round; `gain_hz`, K_f > 0, is how much
  /// of the difference it makes good per second. @pre arguments finite, 0 <= dt_s <= 1
  void Update(double gain_hz, double psi_ref_rad, double dt_s);
};

/// How deep a vehicle may go.
struct DepthLimits {
  double max_z_m = 100;           ///< What the hull or the mission allows.
  double seabed_clearance_m = 5;  ///< z_safe.
};

/// Returns `z_m`, kept above the limits and not above the surface. `seabed_z_m` may be infinite.
/// @pre z_m finite
[[nodiscard]] double LimitDepth(double z_m, const DepthLimits& limits, double seabed_z_m);

struct DepthFilterParams {
  double time_s = 20;             ///< Time constant, > 0.
  bool settles_per_step = false;  ///< As muNet: the time constant is one step, whatever its length.
};

/// Low-pass filter of first order for a commanded depth.
struct DepthFilter {
  double z_d_m = 0;

  /// Returns the filtered depth. @pre arguments finite, dt_s >= 0
  double Update(const DepthFilterParams& params, double z_m, double dt_s);
};

/// Returns the revolutions after `dt_s` on the way from `rpm` to `setpoint_rpm`, which change by no
/// more than `max_rate_rpmps` >= 0. An infinite rate is a constant propeller. @pre dt_s > 0
[[nodiscard]] double RampRpm(double rpm, double setpoint_rpm, double max_rate_rpmps, double dt_s);

}  // namespace shoal
