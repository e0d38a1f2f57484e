// A Remus 100 under shoal's laws, with the options that make it muNet's, in the order of muNet's
// loop: guidance and autopilots at a state, then the model's step. (Between processes a command
// takes a step more: whole_swarm_test.cc.)
//
//   MunetAuv leader(state, psi_rad, z_m);
//   leader.TakePath(waypoints_m, 1200);
//   leader.DecideOnPath();
//   leader.Step({.current_mps = current_mps});
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "lib/vehicle/control/auv_pilot.h"
#include "lib/vehicle/guidance/path_follower.h"
#include "lib/vehicle/guidance/target_tracker.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal {

inline constexpr double kMunetStep_s = 0.02;
inline constexpr double kMunetSeabed_m = 6000;  ///< What muNet takes an unknown floor for.

class MunetAuv {
 public:
  /// A vehicle with autopilots that begin at `psi_d_rad` and `z_d_m`.
  MunetAuv(const Remus100State& start, double psi_d_rad, double z_d_m);

  /// Gives it a path: waypoints passed along the track, the bare ALOS, a propeller at `rpm`.
  void TakePath(const std::vector<Eigen::Vector3d>& waypoints_m, double rpm);
  /// Gives it a target, by `law`.
  void TakeTarget(const VelocityLaw& law);

  /// Decides at the state as it is. @pre TakePath
  void DecideOnPath();
  /// Decides by its law. @pre TakeTarget
  void DecideOnTarget(const Surroundings& surroundings);
  /// Decides to move so: what a law of the test's own wants.
  void DecideOnVelocity(const Eigen::Vector3d& velocity_mps, double held_psi_rad);

  /// Advances the model by the last decision.
  void Step(const Remus100Environment& environment);

  Neighbour AsNeighbour(int id) const;
  Eigen::Vector3d position_m() const { return state.eta.head<3>(); }

  Remus100State state;
  std::optional<Remus100State> seen_by_pilot;  ///< What its autopilots go by; absent: `state`.
  Remus100Actuators command;                   ///< The last decision.
  AuvPilot pilot;
  PathGuidance path_guidance;  ///< Of the last DecideOnPath.
  size_t leg = 0;              ///< After it: the waypoint at which the current leg begins.

 private:
  AuvMotion Motion() const;
  void Steer(const TrackCommand& track);

  std::optional<PathFollower> follower_;
  std::optional<TargetTracker> tracker_;
  double rpm_ = 0;
};

}  // namespace shoal
