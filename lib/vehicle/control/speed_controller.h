// Speed autopilot: the thrust that the vessel's own map foresees, corrected by a PI.
//
//   SpeedController speed({.kp = 5, .ki = 2, .integral_limit_pct = 20, .acceleration_mps2 = 0.5});
//   double thrust_pct = speed.Update(desired_mps, feed_forward_pct, measured_mps, dt_s);
//
// The PI compares the measured speed with a reference that runs up to the desired speed no faster
// than the vessel can follow. Against the desired speed itself the integral would grow all through
// an acceleration and overshoot afterwards.
#pragma once

#include <optional>

namespace shoal {

struct SpeedGains {
  double kp = 0;                    ///< Per cent of thrust per m/s of error.
  double ki = 0;                    ///< Per cent of thrust per metre of error.
  double integral_limit_pct = 100;  ///< Bound of the integral term, >= 0.
  double acceleration_mps2 = 0.5;   ///< What the vessel can do; > 0.
};

class SpeedController {
 public:
  explicit SpeedController(const SpeedGains& gains) : gains_(gains) {}

  /// Returns the thrust in [0, 100]: `feed_forward_pct` keeps up `desired_mps` if the map is right.
  /// A desired speed of zero or less gives none and resets.
  /// @pre arguments finite, dt_s >= 0
  double Update(double desired_mps, double feed_forward_pct, double measured_mps, double dt_s);

  /// Forgets integral and reference: the vessel was not under this autopilot's command.
  void Reset();

 private:
  SpeedGains gains_;
  double integral_pct_ = 0;
  std::optional<double> reference_mps_;  ///< Absent: begins at the measured speed.
};

}  // namespace shoal
