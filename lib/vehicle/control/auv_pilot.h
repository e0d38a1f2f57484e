// Autopilot of an underwater vehicle: heading, depth or pitch, and speed of the propeller, to the
// deflections that keep them.
//
//   AuvPilot pilot(DefaultRemusPilot());
//   pilot.Start(psi, z);
//   AuvDeflections fins = pilot.KeepHeadingAndDepth(motion, psi_ref, z_ref, bound, dt_s);
//
// The structure is muNet's: the heading goes through a LOS observer to a PID; the depth through a
// filter and its limits to a PI, whose pitch a PID keeps.
#pragma once

#include <limits>
#include <optional>

#include "lib/vehicle/control/angle_pid.h"
#include "lib/vehicle/control/floor_ahead.h"
#include "lib/vehicle/control/reference_filters.h"

namespace shoal {

struct AuvPilotParams {
  AnglePidGains heading = {};
  AnglePidGains pitch = {};
  DepthPiGains depth = {};
  double heading_observer_hz = 0.5;  ///< K_f.
  DepthLimits depth_limits = {};
  DepthFilterParams depth_filter = {};
  double least_z_m = 0;          ///< Not steered for less: where the hull floats.
  double least_speed_mps = 0.3;  ///< Slower, the fins have no water: they are centred.
  bool feeds_forward = true;     ///< The slope of a bound; muNet's does not.
};

/// Returns gains for the default Remus 100 and for that of Fossen: fins of 15 degrees and 0.1 s. To
/// be updated every 0.2 s or faster.
[[nodiscard]] AuvPilotParams DefaultRemusPilot();

/// Returns muNet's gains, for its Remus 100 only: the sign of its stern plane is that of its model.
[[nodiscard]] AuvPilotParams MunetRemusPilot();

/// What the autopilot knows of the vehicle's motion; the guidance frame.
struct AuvMotion {
  double z_m = 0;
  double theta_rad = 0;
  double psi_rad = 0;
  double q_radps = 0;
  double r_radps = 0;
  double speed_mps = 0;   ///< Through water.
  bool is_driven = true;  ///< The propeller turns; else the integrals are held.
  double level_rad = 0;   ///< Pitch, bow up, at which it goes on a level; 0: it is neutral.
};

struct AuvDeflections {
  double rudder_rad = 0;
  double stern_plane_rad = 0;
};

/// Returns the pitch, bow up, of a vehicle that goes down by `z_rate_mps` at `speed_mps` through
/// water. Slower than 0.5 m/s, where fins do not lift, it counts as 0.5 m/s. @pre arguments finite
[[nodiscard]] double PitchOfDescent(double z_rate_mps, double speed_mps);

class AuvPilot {
 public:
  explicit AuvPilot(const AuvPilotParams& params) : params_(params) {}

  /// Forgets the past: the references begin where the vehicle is.
  void Start(double psi_rad, double z_m);

  /// Steers for a heading of path following and a depth, no deeper than `bound`, whose slope ahead
  /// is fed forward. With `path_pitch_rad` the depth moves already, at that pitch of the path: it
  /// is not filtered. Below least_speed_mps the fins are centred and it starts again.
  /// @pre arguments finite, but for the bound; 0 < dt_s <= 1
  AuvDeflections KeepHeadingAndDepth(const AuvMotion& motion, double psi_ref_rad, double z_ref_m,
                                     const DepthBound& bound, double dt_s,
                                     std::optional<double> path_pitch_rad = {});

  /// Steers for a direction of target tracking: heading and pitch at once, without filters; the
  /// pitch is raised where that is needed to stay above `bound` and the greatest depth. Slow as
  /// above. @pre arguments finite, but for the bound; 0 < dt_s <= 1
  AuvDeflections KeepHeadingAndPitch(const AuvMotion& motion, double psi_d_rad, double theta_d_rad,
                                     const DepthBound& bound, double dt_s);

  const AuvPilotParams& params() const { return params_; }
  double desired_psi_rad() const { return observer_.psi_d_rad; }
  double desired_yaw_rate_radps() const { return observer_.r_d_radps; }
  double desired_z_m() const { return depth_filter_.z_d_m; }
  double desired_theta_rad() const { return theta_d_rad_; }

 private:
  AuvDeflections Drift(const AuvMotion& motion);
  AuvDeflections Deflect(const AuvMotion& motion, double psi_d_rad, double dt_s);
  /// Moves the desired depth toward `goal_m`, along with a bound that is less deep.
  void MoveDesiredDepth(const AuvMotion& motion, double goal_m, double bound_m, double along_rad,
                        double dt_s);
  double RaisedPitch(const AuvMotion& motion, double theta_d_rad, const DepthBound& bound,
                     double dt_s);
  /// Returns the pitch at which the vehicle rises as `bound` does, where that limits `goal_m`.
  double PitchAlong(const DepthBound& bound, double goal_m, double speed_mps) const;

  AuvPilotParams params_;
  HeadingObserver observer_;
  DepthFilter depth_filter_;
  AnglePid heading_;
  AnglePid pitch_;
  DepthPi depth_;
  double bound_m_ = std::numeric_limits<double>::infinity();  ///< Of the last step.
  double theta_d_rad_ = 0;
};

}  // namespace shoal
