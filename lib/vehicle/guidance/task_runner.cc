#include "lib/vehicle/guidance/task_runner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

namespace {

/// A vehicle this slow has come to rest: its fins hold nothing any more.
constexpr double kAtRest_mps = 0.3;

// Returns the corner at which entering costs least: the way there, and a diameter for every radian
// that the vessel would then have to turn into the sense of rotation. From outside that is the
// corner to which the way is a tangent, on the circle itself the next one ahead.
size_t EntryCorner(const LoiterTask& task, const std::vector<Eigen::Vector2d>& corners_m,
                   const Eigen::Vector2d& position_m) {
  size_t best = 0;
  double best_cost_m = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < corners_m.size(); ++i) {
    const double sailing_rad =
        HeadingOf(corners_m[i] - task.center_m) + (task.clockwise ? kPi / 2 : -kPi / 2);
    const Eigen::Vector2d way_m = corners_m[i] - position_m;
    const double turn_rad = way_m.norm() > 0 ? std::abs(WrapPi(sailing_rad - HeadingOf(way_m))) : 0;
    const double cost_m = way_m.norm() + 2 * task.radius_m * turn_rad;
    if (cost_m < best_cost_m) {
      best_cost_m = cost_m;
      best = i;
    }
  }
  return best;
}

// Corners closer together than the capture radius would all be reached at once.
CaptureRule LoiterCapture(const LoiterTask& task) {
  CaptureRule rule = task.capture;
  const double side_m = 2 * task.radius_m * Sin(kPi / task.num_points);
  rule.capture_radius_m = std::min(rule.capture_radius_m, 0.4 * side_m);
  return rule;
}

Fix PlausibleFix(Fix fix) {
  fix.position_m = {Plausible(fix.position_m.x()), Plausible(fix.position_m.y())};
  fix.z_m = Plausible(fix.z_m);
  return fix;
}

StationKeepTask KeepHome(const ReturnTask& task) {
  StationKeepTask keep;
  keep.point_m = task.point_m;
  keep.here = false;
  keep.inner_radius_m = 0.4 * task.outer_radius_m;
  keep.outer_radius_m = task.outer_radius_m;
  // What keeps a depth needs way for its fins.
  keep.speed_mps = task.z_m ? task.speed_mps : std::min(keep.speed_mps, task.speed_mps);
  keep.z_m = task.z_m;
  return keep;
}

Guidance GuidanceAlongLeg(LegFollower& follower, const Fix& fix, double speed_mps, double dt_s) {
  const Leg& leg = follower.leg();
  Guidance guidance;
  guidance.heading_rad = follower.Steer(fix.position_m, dt_s);
  guidance.speed_mps = speed_mps;
  guidance.waypoint_m = leg.to_m;
  guidance.distance_m = (leg.to_m - fix.position_m).norm();
  guidance.cross_track_error_m = Project(leg, fix.position_m).cross_track_m;
  return guidance;
}

}  // namespace

double Stopwatch::Lap(double time_s) {
  const double lap_s = std::max(0.0, time_s - time_s_);
  time_s_ = time_s;
  return lap_s;
}

WaypointsRunner::WaypointsRunner(const WaypointsTask& task, const Fix& start)
    : task_(task),
      follower_({.lookahead_m = task.lookahead_m, .crab_gain = task.crab_gain}, task.capture,
                start.position_m, task.points_m.at(0)),
      stopwatch_(start.time_s),
      rounds_(task.points_m.size()) {}

Guidance WaypointsRunner::Update(const Fix& fix) {
  if (!done_ && follower_.Reached(fix.position_m)) {
    done_ = !rounds_.Pass(task_.laps);
    if (!done_) follower_.Continue(fix.position_m, task_.points_m[rounds_.index()]);
  }
  Guidance guidance = GuidanceAlongLeg(follower_, fix, task_.speed_mps, stopwatch_.Lap(fix.time_s));
  guidance.done = done_;
  guidance.waypoint_index = static_cast<int>(rounds_.index());
  guidance.laps_done = rounds_.num_rounds();
  return guidance;
}

void WaypointsRunner::Rejoin(const Fix& fix) {
  stopwatch_.Lap(fix.time_s);
  follower_.Rejoin(fix.position_m);
}

void WaypointsRunner::Move(const WaypointsTask& task, const Fix& fix) {
  const Eigen::Vector2d to_m = task_.points_m[rounds_.index()];
  task_ = task;
  rounds_.ChangeNumber(task.points_m.size());
  if (task.points_m[rounds_.index()] == to_m) return;
  follower_ = LegFollower({.lookahead_m = task.lookahead_m, .crab_gain = task.crab_gain},
                          task.capture, fix.position_m, task.points_m[rounds_.index()]);
}

LoiterRunner::LoiterRunner(const LoiterTask& task, const Fix& start)
    : task_(task),
      corners_m_(CornersOf(task)),
      rounds_(corners_m_.size(), EntryCorner(task, corners_m_, start.position_m)),
      follower_({.lookahead_m = task.lookahead_m, .crab_gain = task.crab_gain}, LoiterCapture(task),
                start.position_m, corners_m_.at(rounds_.index())),
      stopwatch_(start.time_s) {}

Guidance LoiterRunner::Update(const Fix& fix) {
  const double dt_s = stopwatch_.Lap(fix.time_s);
  elapsed_s_ += dt_s;
  if (follower_.Reached(fix.position_m)) {
    rounds_.Pass();
    follower_.Continue(fix.position_m, corners_m_[rounds_.index()]);
  }
  Guidance guidance = GuidanceAlongLeg(follower_, fix, task_.speed_mps, dt_s);
  guidance.done = task_.duration_s > 0 && elapsed_s_ >= task_.duration_s;
  guidance.waypoint_index = static_cast<int>(rounds_.index());
  guidance.laps_done = rounds_.num_reached() / task_.num_points;
  guidance.z_m = task_.z_m;
  return guidance;
}

void LoiterRunner::Rejoin(const Fix& fix) {
  stopwatch_.Lap(fix.time_s);
  follower_.Rejoin(fix.position_m);
}

StationKeepRunner::StationKeepRunner(const StationKeepTask& task, const Fix& start)
    : task_(task),
      stopwatch_(start.time_s),
      point_m_(task.here ? start.position_m : task.point_m),
      heading_rad_(start.heading_rad),
      has_place_(!task.stops_first || !task.here) {}

Guidance StationKeepRunner::Update(const Fix& fix) {
  const double dt_s = stopwatch_.Lap(fix.time_s);
  const bool is_off_depth = task_.z_m && depth_band_.IsLeft(fix.z_m - *task_.z_m, dt_s);
  if (!has_place_) {
    point_m_ = fix.position_m;
    has_place_ = fix.speed_mps < kAtRest_mps || is_off_depth;
  }
  Guidance guidance;
  guidance.waypoint_m = point_m_;
  guidance.distance_m = (point_m_ - fix.position_m).norm();
  guidance.z_m = task_.z_m;
  const bool is_inside = guidance.distance_m < task_.inner_radius_m;
  if (guidance.distance_m > task_.outer_radius_m) is_outside_ = true;
  if (is_inside) is_outside_ = false;
  const bool goes_back = is_outside_ || is_off_depth;
  if (!goes_back || !is_inside) {
    heading_rad_ = goes_back ? HeadingOf(point_m_ - fix.position_m) : fix.heading_rad;
  }
  guidance.heading_rad = heading_rad_;
  guidance.speed_mps = goes_back ? task_.speed_mps : 0;
  return guidance;
}

ReturnRunner::ReturnRunner(const ReturnTask& task, const Fix& start)
    : task_(task),
      follower_(AlosParams{}, task.capture, start.position_m, task.point_m),
      stopwatch_(start.time_s),
      keeper_(KeepHome(task), start) {}

Guidance ReturnRunner::Update(const Fix& fix) {
  const double dt_s = stopwatch_.Lap(fix.time_s);
  arrived_ = arrived_ || follower_.Reached(fix.position_m);
  Guidance guidance;
  if (arrived_) {
    guidance = keeper_.Update(fix);
    guidance.laps_done = 1;
  } else {
    guidance = GuidanceAlongLeg(follower_, fix, task_.speed_mps, dt_s);
    guidance.waypoint_index = 0;
    guidance.z_m = task_.z_m;
  }
  return guidance;
}

void ReturnRunner::Rejoin(const Fix& fix) {
  stopwatch_.Lap(fix.time_s);
  follower_.Rejoin(fix.position_m);
}

SurveyRunner::SurveyRunner(const SurveyTask& task, const Fix& start)
    : points_({.points_m = PointsOf(task),
               .speed_mps = task.speed_mps,
               .capture = task.capture,
               .lookahead_m = task.lookahead_m,
               .crab_gain = task.crab_gain},
              start) {}

namespace {

using What = TaskRunner::What;
using Runner = TaskRunner::Runner;

static_assert(std::variant_size_v<What> == std::variant_size_v<Runner>,
              "every kind of task has a runner");

/// Starts the runner that has the place of the task's kind.
template <size_t kPlace = 0>
Runner StartRunner(const What& what, const Fix& start) {
  if constexpr (kPlace + 1 < std::variant_size_v<What>) {
    if (what.index() != kPlace) return StartRunner<kPlace + 1>(what, start);
  }
  return Runner(std::in_place_index<kPlace>, std::get<kPlace>(what), start);
}

}  // namespace

TaskRunner::TaskRunner(const What& what, const Fix& start)
    : runner_(StartRunner(what, PlausibleFix(start))) {}

Guidance TaskRunner::Update(const Fix& fix) {
  const Fix bounded = PlausibleFix(fix);
  return std::visit([&](auto& runner) { return runner.Update(bounded); }, runner_);
}

void TaskRunner::Rejoin(const Fix& fix) {
  const Fix bounded = PlausibleFix(fix);
  std::visit([&](auto& runner) { runner.Rejoin(bounded); }, runner_);
}

void TaskRunner::Move(const What& what, const Fix& fix) {
  const Fix bounded = PlausibleFix(fix);
  auto* waypoints = std::get_if<WaypointsRunner>(&runner_);
  if (waypoints != nullptr) {
    waypoints->Move(std::get<WaypointsTask>(what), bounded);
  } else {
    runner_ = StartRunner(what, bounded);
  }
}

}  // namespace shoal
