// How far along a path of waypoints a vehicle has come: which leg it is on, when a waypoint counts
// as reached, what comes after the last one.
//
//   PathProgress progress{.start_m = position_m};
//   PathLeg leg = CurrentLeg(path, end, progress, position_m);
//   progress = Advance(path, rule, end, progress, position_m);
//
//   leg 0 -> leg 1 -> ... -> leg n-2 -> kGoOn, kHold, kSurface: ended
//     ^                                 kReturnToFirst: leg n-1, from the last point to the first
//     +----------------------------------------------------------------+
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "lib/guidance/waypoint_path.h"

namespace shoal {

/// When a waypoint counts as reached, in the horizontal plane; R is the acceptance radius.
enum class SwitchRule {
  kCircleOrPassedLine,  ///< Within R, or past the line through the waypoint square to the leg.
  kCircle,              ///< Within R.
  kPassedLine,          ///< Past the line through the waypoint, however far abeam.
  kAlongTrack,          ///< Past the line R before the waypoint, however far abeam: MuNet's.
};

struct WaypointSwitch {
  SwitchRule rule = SwitchRule::kCircleOrPassedLine;
  double acceptance_radius_m = 10;  ///< R; >= 0.

  bool operator==(const WaypointSwitch&) const = default;
};

/// What a vehicle does at the end of its path.
enum class PathEnd {
  kGoOn,           ///< Keeps the last leg's course and depth, for ever.
  kHold,           ///< Stops, and comes back when it has drifted away.
  kReturnToFirst,  ///< Goes to the first waypoint and follows the path again, for ever.
  kSurface,        ///< Comes up on the last leg's course and stops its propeller there.
};

/// A straight part of a path.
struct PathLeg {
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();
  double psi_rad = 0;   ///< Path-tangential angle pi_h.
  double length_m = 0;  ///< Horizontal.
};

struct PathProgress {
  size_t previous = 0;  ///< The waypoint at which the current leg begins.
  Eigen::Vector3d start_m = Eigen::Vector3d::Zero();  ///< A path of one waypoint begins here.
  int laps_done = 0;                                  ///< kReturnToFirst only.
  bool ended = false;  ///< The last waypoint is behind; never with kReturnToFirst.
};

/// Past the end, `to_m` of a leg is this far ahead of the vehicle. MuNet has 1e10 m, which a peer
/// that checks received values takes for damage.
inline constexpr double kOpenEnd_m = 1000;

/// Returns the leg that the vehicle is on. Past the end: from the last waypoint along the last
/// leg's psi, to kOpenEnd_m ahead of `position_m`. A leg without horizontal length has the psi of
/// the leg before it. A path of one waypoint has one leg, from `start_m`.
/// @pre the path has a waypoint, everything is finite
[[nodiscard]] PathLeg CurrentLeg(const WaypointPath& path, PathEnd end,
                                 const PathProgress& progress, const Eigen::Vector3d& position_m);

/// Along-track distance x_e and cross-track error y_e, positive toward growing psi:
///
///   [x_e, y_e]^T = R(pi_h)^T ([x, y] - [x_1, y_1])^T       Fossen (2021), chapter 12
struct TrackErrors {
  double x_e_m = 0;
  double y_e_m = 0;
};

[[nodiscard]] TrackErrors ErrorsOn(const PathLeg& leg, const Eigen::Vector3d& position_m);

/// Returns whether the end of `leg` counts as reached. A leg without length ends where it begins:
/// it is reached within R, or past the line through that point square to its psi.
[[nodiscard]] bool IsReached(const WaypointSwitch& rule, const PathLeg& leg,
                             const Eigen::Vector3d& position_m);

/// Returns the progress of the next step: one waypoint on where the current leg's end is reached.
/// @pre as CurrentLeg
[[nodiscard]] PathProgress Advance(const WaypointPath& path, const WaypointSwitch& rule,
                                   PathEnd end, PathProgress progress,
                                   const Eigen::Vector3d& position_m);

}  // namespace shoal
