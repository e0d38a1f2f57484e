#include "tests/closed_loops/munet_auv.h"

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/propulsion.h"

namespace shoal {

namespace {

const Remus100& Munet() {
  static const Remus100 auv = BuildRemus100(MunetRemus100());
  return auv;
}

}  // namespace

MunetAuv::MunetAuv(const Remus100State& start, double psi_d_rad, double z_d_m)
    : state(start), pilot(MunetRemusPilot()) {
  pilot.Start(psi_d_rad, z_d_m);
}

void MunetAuv::TakePath(const std::vector<Eigen::Vector3d>& waypoints_m, double rpm) {
  rpm_ = rpm;
  follower_.emplace(
      PathFollowParams{.path = {waypoints_m},
                       .waypoint_switch = {SwitchRule::kAlongTrack, /*acceptance_radius_m=*/10},
                       .end = PathEnd::kGoOn,
                       .alos = {.lookahead_m = 10, .crab_gain = 0.0006},
                       .guard_crab = false,
                       .turn_crab = false},
      position_m());
}

void MunetAuv::TakeTarget(const VelocityLaw& law) {
  tracker_.emplace(TargetTrackParams{.law = law, .max_pitch_rad = kPi / 2}, state.eta[5]);
}

void MunetAuv::DecideOnPath() {
  path_guidance = follower_->Update(position_m(), kMunetStep_s);
  leg = follower_->progress().previous;
  const AuvDeflections fins = pilot.KeepHeadingAndDepth(Motion(), path_guidance.psi_ref_rad,
                                                        path_guidance.z_m, {}, kMunetStep_s);
  command = {fins.rudder_rad, fins.stern_plane_rad, rpm_};
}

void MunetAuv::DecideOnTarget(const Surroundings& surroundings) {
  Steer(tracker_->Update(surroundings));
}

void MunetAuv::DecideOnVelocity(const Eigen::Vector3d& velocity_mps, double held_psi_rad) {
  Steer(CommandOf(velocity_mps, held_psi_rad, kPi / 2));
}

void MunetAuv::Steer(const TrackCommand& track) {
  const AuvDeflections fins =
      pilot.KeepHeadingAndPitch(Motion(), track.psi_d_rad, track.theta_d_rad, {}, kMunetStep_s);
  command = {fins.rudder_rad, fins.stern_plane_rad, track.Rpm(MunetRpmFromSpeed)};
}

void MunetAuv::Step(const Remus100Environment& environment) {
  state = shoal::Step(Munet(), state, command, environment, kMunetStep_s);
}

Neighbour MunetAuv::AsNeighbour(int id) const {
  return {.id = id, .position_m = position_m(), .velocity_mps = state.velocity_mps};
}

AuvMotion MunetAuv::Motion() const {
  const Remus100State& seen = seen_by_pilot ? *seen_by_pilot : state;
  return {.z_m = seen.eta[2],
          .theta_rad = seen.eta[4],
          .psi_rad = seen.eta[5],
          .q_radps = seen.nu[4],
          .r_radps = seen.nu[5]};
}

}  // namespace shoal
