// Tasks of underwater vehicles: from the laws of this library, which count psi from East toward
// North, to headings.
#include <algorithm>
#include <iterator>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/task_runner.h"
#include "lib/vehicle/guidance/way_among_others.h"

namespace shoal {

namespace {

/// A vehicle this deep has come up.
constexpr double kAtSurface_m = 0.5;
/// A vehicle deeper than this is under water.
constexpr double kDeep_m = 2;
/// A target at the surface rests when it is slower than the first, relative to the water, for
/// kSettle_s; it has left when it is faster than the second for as long.
constexpr double kTargetRests_mps = 0.3;
constexpr double kTargetLeaves_mps = 0.6;
constexpr double kSettle_s = 10;
/// Less than this share of its speed away from others is not worth leaving a place for.
constexpr double kNudge = 0.05;

/// Returns the law's layer that keeps clear of the group; muNet's where it has none.
SurvivalGroupLayer SurvivalOf(const VelocityLaw& law) {
  if (const auto* cascade = std::get_if<VelocityCascade>(&law)) {
    for (const VelocityLayer& layer : cascade->layers) {
      if (const SurvivalGroupLayer* group = GroupOf(layer)) return *group;
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
    case PathTaskEnd::kLoiter:
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
  // While layers steer, the cross-track error does not show the current: ALOS learns nothing.
  const double dt_s = stopwatch_.Lap(fix.time_s);
  const PathGuidance path = follower_.Update(PositionOf(fix), keeps_clear_ ? 0 : dt_s);
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
  guidance.crab_rad = -path.crab_rad;
  if (path.slope) guidance.z_rate_mps = *path.slope * SpeedAlong(path.psi_rad, fix);
  if (task_.propeller_rpm > 0 && path.speed_mps > 0) guidance.propeller_rpm = task_.propeller_rpm;
  if (task_.end == PathTaskEnd::kLoiter && path.done) {
    const int index = guidance.waypoint_index;  // Of the path's points it passes none again.
    const int laps_done = guidance.laps_done;
    guidance = Loiter(path.next_m, fix);
    guidance.waypoint_index = index;
    guidance.laps_done = laps_done;
  }
  keeps_clear_ = !task_.cascade.layers.empty() && KeepClear(task_, fix, &guidance);
  return guidance;
}

Guidance PathFollowRunner::Loiter(const Eigen::Vector3d& center_m, const Fix& fix) {
  if (!loiter_) {
    const LoiterTask loiter{.center_m = center_m.head<2>(),
                            .radius_m = task_.loiter_radius_m,
                            .speed_mps = task_.speed_mps,
                            .z_m = center_m.z()};
    loiter_.emplace(loiter, fix);
  }
  Guidance guidance = loiter_->Update(fix);
  if (task_.propeller_rpm > 0) guidance.propeller_rpm = task_.propeller_rpm;
  return guidance;
}

void PathFollowRunner::Rejoin(const Fix& fix) {
  stopwatch_.Lap(fix.time_s);
  if (loiter_) loiter_->Rejoin(fix);
}

Guidance SurfaceRunner::Update(const Fix& fix) {
  if (fix.z_m <= kAtSurface_m) is_up_ = true;
  if (fix.z_m > kDeep_m) is_up_ = false;
  Guidance guidance;
  guidance.heading_rad = heading_rad_;
  // Fins lift only a vehicle that moves.
  guidance.speed_mps = is_up_ ? 0 : speed_mps_;
  guidance.done = is_up_;
  guidance.waypoint_m = start_m_;
  guidance.distance_m = (start_m_ - fix.position_m).norm();
  guidance.z_m = 0;
  return guidance;
}

bool TargetEndWatch::Look(const Surroundings& surroundings, double time_s) {
  if (!surroundings.target || surroundings.target_is_silent) return rests_;
  const Neighbour& target = *surroundings.target;
  const double speed_mps = (target.velocity_mps - surroundings.current_mps).norm();
  const double z_m = target.position_m.z();
  if (z_m > kDeep_m) was_deep_ = true;
  const bool changes = rests_ ? z_m > kDeep_m || speed_mps > kTargetLeaves_mps
                              : was_deep_ && z_m <= kAtSurface_m && speed_mps < kTargetRests_mps;
  if (!changes) {
    differs_since_s_.reset();
    return rests_;
  }
  if (!differs_since_s_) differs_since_s_ = time_s;
  if (time_s - *differs_since_s_ >= kSettle_s) {
    rests_ = !rests_;
    differs_since_s_.reset();
  }
  return rests_;
}

TargetTrackRunner::TargetTrackRunner(const TargetTrackTask& task, const Fix& start)
    : tracker_(task.track, PsiFromHeading(start.heading_rad)), task_(task) {}

Guidance TargetTrackRunner::Update(const Fix& fix) {
  if (const std::optional<Wait> wait = WaitAt(fix)) return WaitFor(*wait, fix);
  wait_.reset();
  return Follow(fix);
}

std::optional<TargetTrackRunner::Wait> TargetTrackRunner::WaitAt(const Fix& fix) {
  if (fix.surroundings == nullptr) return std::nullopt;
  const bool target_rests = end_watch_.Look(*fix.surroundings, fix.time_s);
  if (fix.surroundings->target_is_silent && task_.on_silence != SilenceRule::kPredict) {
    return task_.on_silence == SilenceRule::kSurface ? Wait::kSurface : Wait::kHold;
  }
  if (!target_rests || task_.on_target_end == TargetEndRule::kGoOn) return std::nullopt;
  return task_.on_target_end == TargetEndRule::kSurface ? Wait::kSurface : Wait::kHold;
}

Guidance TargetTrackRunner::WaitFor(Wait wait, const Fix& fix) {
  const bool holds = wait == Wait::kHold;
  if (!wait_ || std::holds_alternative<StationKeepRunner>(*wait_) != holds) {
    if (holds) {
      wait_ = StationKeepRunner(HoldHere(task_.hold_radius_m, fix.z_m), fix);
    } else {
      wait_ = SurfaceRunner(SurfaceTask{}, fix);
    }
  }
  Guidance guidance = std::visit([&](auto& runner) { return runner.Update(fix); }, *wait_);
  guidance.done = task_.on_target_end == TargetEndRule::kDone && end_watch_.target_rests();
  AvoidOthers(*fix.surroundings, &guidance);
  return guidance;
}

// Keeps clear of the target and the members that still report: the positions of silent ones are
// unknown.
void TargetTrackRunner::AvoidOthers(const Surroundings& surroundings, Guidance* guidance) const {
  std::vector<Neighbour> reporting;
  std::copy_if(surroundings.group.begin(), surroundings.group.end(), std::back_inserter(reporting),
               [](const Neighbour& neighbour) { return !neighbour.is_silent; });
  if (surroundings.target && !surroundings.target_is_silent) {
    reporting.push_back(*surroundings.target);
  }
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
  if (task_.compensate_current) {
    command = CommandOf(command.velocity_mps - fix.surroundings->current_mps, command.psi_d_rad,
                        tracker_.params().max_pitch_rad);
  }
  if (task_.speed_along_bow) {
    room_.Limit(*fix.surroundings, PsiFromHeading(fix.heading_rad), tracker_.params().u_max_mps,
                &command);
  }
  const Eigen::Vector3d& target_m = fix.surroundings->target->position_m;
  guidance.heading_rad = HeadingFromPsi(command.psi_d_rad);
  guidance.speed_mps = command.speed_mps;
  guidance.pitch_rad = command.theta_d_rad;
  guidance.waypoint_m = target_m.head<2>();
  guidance.distance_m = (target_m - PositionOf(fix)).norm();
  guidance.layers = tracker_.shares();
  if (!guidance.layers.empty()) guidance.u_max_mps = tracker_.params().u_max_mps;
  return guidance;
}

}  // namespace shoal
