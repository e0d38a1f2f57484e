// Heading autopilot: heading error to rudder, by a PID whose derivative acts on the measured yaw
// rate (a step of the desired heading gives no kick) and whose integral never winds up.
//
//   HeadingPid pid({.kp = 1.2, .ki = 0.02, .kd = 0.6});
//   double rudder_pct = pid.Update(desired_deg, heading_deg, yaw_rate_degps, dt_s);
#pragma once

namespace shoal {

/// In per cent of full rudder, so that gains do not depend on how far a rudder swings.
struct HeadingGains {
  double kp = 0;                    ///< Per degree of error.
  double ki = 0;                    ///< Per degree of error and second.
  double kd = 0;                    ///< Per degree per second of yaw rate.
  double integral_limit_pct = 100;  ///< Bound of the integral term, >= 0.
};

class HeadingPid {
 public:
  explicit HeadingPid(const HeadingGains& gains) : gains_(gains) {}

  /// Returns the rudder in [-100, 100], positive to starboard; turns the shorter way round. The
  /// integral stands still where it would only push a saturated rudder further.
  /// @pre arguments finite, dt_s >= 0
  double Update(double desired_deg, double heading_deg, double yaw_rate_degps, double dt_s);

  /// Forgets the integral: the vessel was not under this autopilot's command.
  void Reset() { integral_pct_ = 0; }

 private:
  HeadingGains gains_;
  double integral_pct_ = 0;
};

}  // namespace shoal
