// How far along a path of waypoints a vehicle has come: which leg it is on, when a waypoint counts
// as reached, what comes after the last one.
//
//   PathProgress progress{.start_m = position_m};
//   PathLeg leg = CurrentLeg(path, end, progress, position_m);
//   progress = Advance(path, rule, end, progress, position_m);
//
//   approach -> leg 0 -> leg 1 -> ... -> leg n-2 -> kGoOn, kHold, kSurface: ended
//                 ^                                 kReturnToFirst: leg n-1, from the last point to
//                 +--------------------------------------------------+      the first
//
// The approach leads from where the vehicle is to the first waypoint (BeginPath).
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "lib/vehicle/guidance/waypoint_path.h"

namespace shoal {

/// When a waypoint counts as reached, in the horizontal plane; R is the acceptance radius.
enum class SwitchRule {
  kCircleOrPassedLine,  ///< Within R, or past the line through the waypoint square to the leg.
  kCircle,              ///< Within R.
  kPassedLine,          ///< Past the line through the waypoint.
  kAlongTrack,          ///< Past the line R before the waypoint, however far abeam: MuNet's.
};

struct WaypointSwitch {
  SwitchRule rule = SwitchRule::kCircleOrPassedLine;
  double acceptance_radius_m = 10;  ///< R; >= 0.
  /// Past the line counts only this near to the leg; >= 0. More than the 45 m in which a Remus 100
  /// turns round at 2 m/s, so that a wide turn is not a missed waypoint. Not with kAlongTrack.
  double passed_line_within_m = 50;
  bool is_within_leg = false;  ///< R is at most half of the leg, for curves. Not with kCircle.

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
  /// The approach begins here, and a path of one waypoint.
  Eigen::Vector3d start_m = Eigen::Vector3d::Zero();
  bool approaches = false;  ///< On the way to the first waypoint of several.
  int laps_done = 0;        ///< kReturnToFirst only.
  bool ended = false;       ///< The last waypoint is behind; never with kReturnToFirst.

  bool operator==(const PathProgress&) const = default;
};

/// Past the end, `to_m` of a leg is this far ahead of the vehicle. MuNet has 1e10 m, which a peer
/// that checks received values takes for damage.
inline constexpr double kOpenEnd_m = 1000;

/// Returns the progress of a vehicle that begins at `position_m`: with an approach where the first
/// waypoint of several is farther than `acceptance_radius_m` in the horizontal plane.
/// @pre the path has a waypoint, everything is finite
[[nodiscard]] PathProgress BeginPath(const WaypointPath& path, const Eigen::Vector3d& position_m,
                                     double acceptance_radius_m);

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

/// Which depth is commanded on a leg.
enum class DepthRule {
  kNext,   ///< That of the waypoint steered for, at once.
  kSlope,  ///< That of the leg abeam of the vehicle: it glides from waypoint to waypoint.
};

/// Returns the depth of the leg abeam of the vehicle, which at the leg's ends stays as there.
[[nodiscard]] double DepthOn(const PathLeg& leg, const Eigen::Vector3d& position_m);

/// Returns how much the leg descends per horizontal metre; 0 for one without horizontal length.
[[nodiscard]] double SlopeOf(const PathLeg& leg);

/// Returns whether the end of `leg` counts as reached. A leg without length ends where it begins:
/// it is reached within R, or past the line through that point square to its psi.
[[nodiscard]] bool IsReached(const WaypointSwitch& rule, const PathLeg& leg,
                             const Eigen::Vector3d& position_m);

/// Returns the progress one waypoint on. What has ended stays so.
/// @pre the path has a waypoint
[[nodiscard]] PathProgress NextLeg(const WaypointPath& path, PathEnd end, PathProgress progress);

/// Returns the progress of the next step: one waypoint on where the current leg's end is reached.
/// @pre as CurrentLeg
[[nodiscard]] PathProgress Advance(const WaypointPath& path, const WaypointSwitch& rule,
                                   PathEnd end, PathProgress progress,
                                   const Eigen::Vector3d& position_m);

}  // namespace shoal
