// Tasks of underwater vehicles: from the laws of this library, which count psi from East toward
// North, to headings.
#include <algorithm>
#include <iterator>
#include <vector>

#include "lib/geometry/angles.h"
#include "lib/guidance/task_runner.h"

namespace shoal {

namespace {

/// A vehicle this deep has come up.
constexpr double kAtSurface_m = 0.5;
/// How fast a follower without a leader swims up.
constexpr double kRise_mps = 1.5;
/// Less than this share of its speed away from others is not worth leaving a place for.
constexpr double kNudge = 0.05;

/// Returns the law's layer that keeps clear of the group; muNet's where it has none.
SurvivalGroupLayer SurvivalOf(const VelocityLaw& law) {
  if (const auto* cascade = std::get_if<VelocityCascade>(&law)) {
    for (const VelocityLayer& layer : cascade->layers) {
      if (const auto* group = std::get_if<SurvivalGroupLayer>(&layer)) return *group;
      if (const auto* both = std::get_if<SurvivalLayer>(&layer)) return both->group;
    }
  }
  return {};
}

PathEnd EndOf(PathTaskEnd end) {
  switch (end) {
    case PathTaskEnd::kGoOn:
      return PathEnd::kGoOn;
    case PathTaskEnd::kReturnToFirst:
      return PathEnd::kReturnToFirst;
    case PathTaskEnd::kSurface:
      return PathEnd::kSurface;
    case PathTaskEnd::kDone:
    case PathTaskEnd::kHold:
      break;
  }
  return PathEnd::kHold;
}

/// Returns how fast the vehicle moves over ground in the direction `psi_rad`, not backward.
double SpeedAlong(double psi_rad, const Fix& fix) {
  return std::max(0.0, fix.velocity_mps.dot(UnitVector(HeadingFromPsi(psi_rad))));
}

PathFollowParams ParamsOf(const PathFollowTask& task) {
  const JoinedPath joined = PathOf(task);
  WaypointSwitch waypoint_switch = task.waypoint_switch;
  waypoint_switch.is_within_leg = joined.has_curves;
  return {.path = joined.path,
          .waypoint_switch = waypoint_switch,
          .approach = task.approach,
          .depth_rule = task.depth_rule,
          .end = EndOf(task.end),
          .alos = {.lookahead_m = task.lookahead_m, .crab_gain = task.crab_gain},
          .guard_crab = task.guard_crab,
          .turn_crab = task.turn_crab,
          .speed_mps = task.speed_mps,
          .hold_radius_m = task.hold_radius_m};
}

Eigen::Vector3d PositionOf(const Fix& fix) {
  return {fix.position_m.x(), fix.position_m.y(), fix.z_m};
}

}  // namespace

PathFollowRunner::PathFollowRunner(const PathFollowTask& task, const Fix& start)
    : task_(task), follower_(ParamsOf(task), PositionOf(start)), stopwatch_(start.time_s) {}

Guidance PathFollowRunner::Update(const Fix& fix) {
  const PathGuidance path = follower_.Update(PositionOf(fix), stopwatch_.Lap(fix.time_s));
  const bool ends = task_.end == PathTaskEnd::kDone || task_.end == PathTaskEnd::kSurface;
  Guidance guidance;
  guidance.heading_rad = HeadingFromPsi(path.psi_ref_rad);
  guidance.speed_mps = path.speed_mps;
  guidance.done = ends && path.done;
  guidance.waypoint_index = static_cast<int>(path.next);
  guidance.laps_done = path.laps_done + (path.done ? 1 : 0);
  guidance.waypoint_m = path.next_m.head<2>();
  guidance.distance_m = (path.next_m - PositionOf(fix)).norm();
  guidance.cross_track_error_m = -path.y_e_m;
  guidance.z_m = path.z_m;
  if (path.slope) guidance.z_rate_mps = *path.slope * SpeedAlong(path.psi_rad, fix);
  if (task_.propeller_rpm > 0 && path.speed_mps > 0) guidance.propeller_rpm = task_.propeller_rpm;
  return guidance;
}

TargetTrackRunner::TargetTrackRunner(const TargetTrackTask& task, const Fix& start)
    : tracker_(task.track, PsiFromHeading(start.heading_rad)),
      compensate_current_(task.compensate_current),
      on_silence_(task.on_silence) {}

Guidance TargetTrackRunner::Update(const Fix& fix) {
  const bool waits = on_silence_ != SilenceRule::kPredict && fix.surroundings != nullptr &&
                     fix.surroundings->target_is_silent;
  if (waits) return WaitFor(fix);
  silence_.reset();
  return Follow(fix);
}

Guidance TargetTrackRunner::WaitFor(const Fix& fix) {
  if (!silence_) {
    silence_ = Silence{.heading_rad = fix.heading_rad,
                       .z_m = fix.z_m,
                       .keeper = StationKeepRunner(StationKeepTask{}, fix)};
  }
  Guidance guidance = silence_->keeper.Update(fix);
  guidance.z_m = silence_->z_m;
  if (on_silence_ == SilenceRule::kStationKeep) {
    AvoidOthers(*fix.surroundings, &guidance);
    return guidance;
  }
  // Fins lift only a vehicle that moves: it rises on its course, and drifts once it is up.
  guidance.z_m = 0;
  guidance.heading_rad = silence_->heading_rad;
  guidance.speed_mps = fix.z_m > kAtSurface_m ? kRise_mps : 0;
  return guidance;
}

// Keeps clear of the members that still report: the positions of silent ones are unknown.
void TargetTrackRunner::AvoidOthers(const Surroundings& surroundings, Guidance* guidance) const {
  std::vector<Neighbour> reporting;
  std::copy_if(surroundings.group.begin(), surroundings.group.end(), std::back_inserter(reporting),
               [](const Neighbour& neighbour) { return !neighbour.is_silent; });
  Surroundings near = surroundings;
  near.group = reporting;
  const double u_max_mps = tracker_.params().u_max_mps;
  const Eigen::Vector3d away_mps =
      LayerVelocity(SurvivalOf(tracker_.params().law), u_max_mps, near);
  if (away_mps.head<2>().norm() < kNudge * u_max_mps) return;
  guidance->heading_rad = HeadingOf(away_mps.head<2>());
  guidance->speed_mps = std::max(guidance->speed_mps, away_mps.head<2>().norm());
}

Guidance TargetTrackRunner::Follow(const Fix& fix) {
  Guidance guidance;
  guidance.heading_rad = fix.heading_rad;
  if (fix.surroundings == nullptr || !fix.surroundings->target) return guidance;
  TrackCommand command = tracker_.Update(*fix.surroundings);
  if (compensate_current_) {
    command = CommandOf(command.velocity_mps - fix.surroundings->current_mps, command.psi_d_rad,
                        tracker_.params().max_pitch_rad);
  }
  const Eigen::Vector3d& target_m = fix.surroundings->target->position_m;
  guidance.heading_rad = HeadingFromPsi(command.psi_d_rad);
  guidance.speed_mps = command.speed_mps;
  guidance.pitch_rad = command.theta_d_rad;
  guidance.waypoint_m = target_m.head<2>();
  guidance.distance_m = (target_m - PositionOf(fix)).norm();
  return guidance;
}

}  // namespace shoal
