// Adaptive line-of-sight path following: steers for a leg and learns the crab angle that a current
// asks for.
//
//   Alos alos({.lookahead_m = 15, .crab_gain = 0.005});
//   double heading_rad = alos.Update(Course(leg), Project(leg, position_m).cross_track_m, dt_s);
//   alos.TurnBy(WrapPi(Course(next_leg) - Course(leg)));   // at a waypoint
//
// Fossen (2023), "An Adaptive Line-of-Sight (ALOS) Guidance Law for Path Following of Aircraft and
// Marine Craft", IEEE TCST 31(6):
//
//   psi_d         = pi_h - beta_hat - atan(y_e / Delta)
//   d beta_hat/dt = gamma Delta y_e / sqrt(Delta^2 + y_e^2)
//
// The law holds in any frame in which angles grow toward positive y_e. With compass courses that is
// y_e positive to starboard (lib/base/geometry/leg.h), with the guidance frame's psi y_e positive
// to port. A current that sets the vessel toward positive y_e makes beta_hat positive.
#pragma once

namespace shoal {

struct AlosParams {
  double lookahead_m = 15;   ///< Delta; > 0.
  double crab_gain = 0.005;  ///< gamma, rad/(m s); 0: plain line of sight.
};

/// The law as it is above, one step of forward Euler: no bound on beta_hat.
struct AlosStep {
  double heading_rad = 0;  ///< psi_d, in (-pi, pi], by the beta_hat before the step.
  double crab_rad = 0;     ///< beta_hat after the step.
};

/// @pre arguments finite, dt_s >= 0
[[nodiscard]] AlosStep StepAlos(const AlosParams& params, double path_angle_rad,
                                double cross_track_m, double crab_rad, double dt_s);

/// The law with a memory and two guards.
class Alos {
 public:
  /// Bound of beta_hat. A vessel whose speed is sqrt(2) times that of a cross current needs this
  /// much, and plain line of sight leaves it one look-ahead distance beside the path.
  static constexpr double kMaxCrab_rad = 0.7853981633974483;

  explicit Alos(const AlosParams& params) : params_(params) {}

  /// Returns the heading to steer, in (-pi, pi], and adapts the crab angle over `dt_s`. Farther
  /// from the path than the look-ahead distance the error shows the approach and not the
  /// current, and beta_hat stands still: otherwise it winds up and the vessel overshoots.
  /// @pre arguments finite, dt_s >= 0
  double Update(double path_angle_rad, double cross_track_m, double dt_s);

  /// Carries the crab angle over to a path that is turned by `turn_rad`. What is known of the
  /// current is its part across the old path; of that, cos(turn) lies across the new one.
  void TurnBy(double turn_rad);

  double crab_rad() const { return crab_rad_; }

 private:
  AlosParams params_;
  double crab_rad_ = 0;
};

}  // namespace shoal
