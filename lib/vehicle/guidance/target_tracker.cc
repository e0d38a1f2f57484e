#include "lib/vehicle/guidance/target_tracker.h"

#include <algorithm>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

TrackCommand CommandOf(const Eigen::Vector3d& velocity_mps, double held_psi_rad,
                       double max_pitch_rad) {
  constexpr double kStill_mps = 1e-6;
  TrackCommand command{.psi_d_rad = held_psi_rad, .velocity_mps = Plausible(velocity_mps)};
  const Eigen::Vector3d& v_mps = command.velocity_mps;
  command.speed_mps = v_mps.norm();
  if (v_mps.head<2>().norm() >= kStill_mps) {
    command.psi_d_rad = WrapPi(Atan2(v_mps.y(), v_mps.x()));
  }
  if (command.speed_mps >= kStill_mps) {
    const double sine = std::clamp(-v_mps.z() / command.speed_mps, -1.0, 1.0);
    command.theta_d_rad = std::clamp(Asin(sine), -max_pitch_rad, max_pitch_rad);
  }
  return command;
}

double TrackCommand::SpeedAlongBow_mps(double psi_rad) const {
  const auto [sine, cosine] = SinCos(psi_rad);
  const auto [up, level] = SinCos(theta_d_rad);
  return std::max(0.0, velocity_mps.dot(Eigen::Vector3d(level * cosine, level * sine, -up)));
}

TargetTracker::TargetTracker(TargetTrackParams params, double psi_rad)
    : params_(std::move(params)), psi_d_rad_(WrapPi(Plausible(psi_rad))) {}

TrackCommand TargetTracker::Update(const Surroundings& surroundings) {
  shares_.clear();
  const auto* cascade = std::get_if<VelocityCascade>(&params_.law);
  const Eigen::Vector3d wanted_mps =
      cascade != nullptr ? DesiredVelocity(*cascade, params_.u_max_mps, surroundings, &shares_)
                         : DesiredVelocity(std::get<ConstantBearingLaw>(params_.law),
                                           params_.u_max_mps, surroundings);
  const Eigen::Vector3d limited_mps =
      ApplyDepthSafety(params_.depth, surroundings.seabed_z_m, surroundings.own.position_m.z(),
                       surroundings.own.velocity_mps.z(), wanted_mps);
  TrackCommand command = CommandOf(limited_mps, psi_d_rad_, params_.max_pitch_rad);
  psi_d_rad_ = command.psi_d_rad;
  return command;
}

}  // namespace shoal
