// Follows a path of waypoints in three dimensions: the guidance part of path following. Heading
// observer, depth filter and autopilots come after it (lib/vehicle/control).
//
//   PathFollower follower({.path = path, .speed_mps = 2.0}, position_m);
//   PathGuidance guidance = follower.Update(position_m, dt_s);
//
// One follower belongs to one vehicle; copies are independent.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "lib/vehicle/guidance/alos.h"
#include "lib/vehicle/guidance/depth_band.h"
#include "lib/vehicle/guidance/path_progress.h"
#include "lib/vehicle/guidance/waypoint_path.h"

namespace shoal {

struct PathFollowParams {
  WaypointPath path = {};  ///< At least one waypoint.
  WaypointSwitch waypoint_switch = {};
  bool approach = true;  ///< BeginPath; false: on the line of the first leg at once, MuNet's.
  DepthRule depth_rule = DepthRule::kNext;
  /// kSlope: a vehicle needs this long for a new pitch; >= 0. Of 0, 1, 2 and 3 s, those beside this
  /// one let a Remus 100 miss the turning points of a yo-yo least.
  double depth_lead_s = 1.5;
  PathEnd end = PathEnd::kGoOn;
  AlosParams alos{.lookahead_m = 10, .crab_gain = 0.0006};
  bool guard_crab = true;        ///< The guards of Alos; false: the bare law, MuNet's.
  bool turn_crab = true;         ///< Alos::TurnBy at a waypoint; false: beta_hat goes on, MuNet's.
  double speed_mps = 2.0;        ///< Through water; >= 0.
  double hold_radius_m = 30;     ///< kHold: comes back from beyond; >= the acceptance radius.
  double surface_depth_m = 0.5;  ///< kSurface: from here up it has surfaced.
};

/// What path following asks for, and how far it has come.
struct PathGuidance {
  double psi_ref_rad = 0;  ///< In (-pi, pi].
  double z_m = 0;          ///< By the depth rule, unfiltered.
  /// kSlope: how much the path descends per horizontal metre where the vehicle is depth_lead_s from
  /// now.
  std::optional<double> slope = {};
  double speed_mps = 0;
  Eigen::Vector3d next_m = Eigen::Vector3d::Zero();  ///< The waypoint steered for.
  double psi_rad = 0;                                ///< Of the leg.
  double y_e_m = 0;     ///< Cross-track error, positive toward growing psi.
  double crab_rad = 0;  ///< beta_hat.
  size_t next = 0;      ///< Its index; past the end the number of waypoints.
  int laps_done = 0;
  bool done = false;  ///< Past the last waypoint; kSurface: at the surface. Never kReturnToFirst.
};

class PathFollower {
 public:
  /// @pre params.path has a waypoint; everything finite
  PathFollower(PathFollowParams params, const Eigen::Vector3d& position_m);

  /// Returns the guidance at `position_m`, `dt_s` after the last call. If this call counts a
  /// waypoint as reached, the next call leads to the waypoint after it.
  /// @pre position_m finite, dt_s >= 0 and finite
  PathGuidance Update(const Eigen::Vector3d& position_m, double dt_s);

  const PathProgress& progress() const { return progress_; }

 private:
  double Steer(const PathLeg& leg, double y_e_m, double dt_s);
  void Glide(const PathLeg& leg, const Eigen::Vector3d& position_m, PathGuidance* guidance) const;
  void Hold(const Eigen::Vector3d& position_m, double dt_s, PathGuidance* guidance);
  void Surface(const Eigen::Vector3d& position_m, PathGuidance* guidance);

  PathFollowParams params_;
  PathProgress progress_;
  std::optional<PathLeg> leg_before_;  ///< Until its end is abeam, where it was left before.
  Alos alos_;
  double bare_crab_rad_ = 0;  ///< Without the guards.
  double held_psi_rad_ = 0;   ///< The last course steered: kept while it stands.
  bool goes_back_ = false;    ///< kHold: on its way back to the last waypoint.
  DepthBand depth_band_;      ///< kHold.
  bool surfaced_ = false;
};

}  // namespace shoal
