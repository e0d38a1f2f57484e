// Target tracking: from what a vehicle knows of the others to course, pitch and speed for its
// autopilots (lib/vehicle/control).
//
//   TargetTracker tracker({.law = VelocityCascade{}}, psi_rad);
//   TrackCommand command = tracker.Update(surroundings);
//   double rpm = command.Rpm([&](double speed_mps) { return RpmOfSpeed(speed_mps); });
//
// One tracker belongs to one vehicle; copies are independent.
#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/constant_bearing.h"
#include "lib/vehicle/guidance/depth_safety.h"
#include "lib/vehicle/guidance/surroundings.h"
#include "lib/vehicle/guidance/velocity_cascade.h"

namespace shoal {

using VelocityLaw = std::variant<VelocityCascade, ConstantBearingLaw>;

struct TargetTrackParams {
  VelocityLaw law = {};
  DepthSafety depth = {};
  double u_max_mps = 2.5;          ///< >= 0.
  double max_pitch_rad = kPi / 4;  ///< Bound of theta_d, in (0, pi / 2]; MuNet has pi / 2.

  bool operator==(const TargetTrackParams&) const = default;
};

struct TrackCommand {
  double psi_d_rad = 0;                                    ///< In (-pi, pi].
  double theta_d_rad = 0;                                  ///< Nose up positive.
  double speed_mps = 0;                                    ///< >= 0.
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();  ///< What the law wants, depth-limited.

  /// Returns the part of the speed that goes along the bow of a vehicle on `psi_rad` at the pitch
  /// theta_d; 0 where that is astern.
  [[nodiscard]] double SpeedAlongBow_mps(double psi_rad) const;

  /// Returns the propeller speed by the vehicle's own map.
  template <class RpmOfSpeed>
  [[nodiscard]] double Rpm(RpmOfSpeed&& rpm_of_speed) const {
    return rpm_of_speed(speed_mps);
  }
};

/// Returns course and pitch of a desired velocity:
///
///   psi_d = atan2(v_y, v_x)     theta_d = asin(-v_z / |v|), within +-max_pitch     speed = |v|
///
/// Slower than 1 um/s over ground there is no course to read off, and `held_psi_rad` is kept;
/// slower than that in all, theta_d is zero. @pre everything finite
[[nodiscard]] TrackCommand CommandOf(const Eigen::Vector3d& velocity_mps, double held_psi_rad,
                                     double max_pitch_rad);

class TargetTracker {
 public:
  /// `psi_rad`: the course to keep until there is one to go.
  TargetTracker(TargetTrackParams params, double psi_rad);

  /// @pre surroundings are finite
  TrackCommand Update(const Surroundings& surroundings);

  const TargetTrackParams& params() const { return params_; }
  /// Returns what the layers of the cascade wanted in the last Update; nothing of another law.
  const std::vector<LayerShare>& shares() const { return shares_; }

 private:
  TargetTrackParams params_;
  std::vector<LayerShare> shares_;
  double psi_d_rad_;
};

}  // namespace shoal
