// PID law for an angle of an underwater vehicle, heading or pitch, with a limited deflection.
//
//   AnglePid pitch;
//   double stern_plane_rad = pitch.Update(DefaultRemusPilot().pitch, theta, theta_d, q, dt_s);
//
//   delta = kp e + ki integral(e) + kd rate,   e = angle - desired, the shorter way round
//
// Fossen (2021), Handbook of Marine Craft Hydrodynamics and Motion Control, chapter 15. The gains
// carry the sign: negative where a positive deflection makes the angle grow.
#pragma once

namespace shoal {

struct AnglePidGains {
  double kp = 0;              ///< Per radian.
  double ki = 0;              ///< Per radian and second; same sign as `kp`, or 0.
  double kd = 0;              ///< Per radian per second.
  double max_output_rad = 0;  ///< Limit of the deflection, >= 0.

  bool operator==(const AnglePidGains&) const = default;
};

/// The memory of such a law.
struct AnglePid {
  double integral_rads = 0;

  /// Returns the deflection, and adapts the integral: it grows by the error, or, at the limit, is
  /// set so that the law asks for just that (muNet's anti-windup, by back-calculation). With dt_s =
  /// 0 it is held. Huge inputs give a finite answer. @pre arguments finite, dt_s >= 0
  double Update(const AnglePidGains& gains, double angle_rad, double desired_rad, double rate_radps,
                double dt_s);
};

/// From depth to pitch: the outer loop of a depth cascade.
struct DepthPiGains {
  double kp = 0;             ///< Radian per metre; positive: pitches up when too deep.
  double ki = 0;             ///< Per second as well.
  double max_pitch_rad = 0;  ///< Limit of the pitch asked for, >= 0.

  bool operator==(const DepthPiGains&) const = default;
};

struct DepthPi {
  double integral_ms = 0;

  /// Returns the desired pitch; anti-windup as in AnglePid. `feed_forward_rad` is the pitch that
  /// the desired depth's own motion takes. @pre arguments finite, dt_s >= 0
  double Update(const DepthPiGains& gains, double z_m, double desired_z_m, double dt_s,
                double feed_forward_rad = 0);
};

}  // namespace shoal
