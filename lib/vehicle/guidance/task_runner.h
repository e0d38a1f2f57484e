// Carries out one task: from where the vessel is to where it shall head, and how fast.
//
//   TaskRunner runner(task.what, {.position_m = p, .heading_rad = h, .time_s = t});
//   Guidance guidance = runner.Update({.position_m = p, .heading_rad = h, .time_s = t});
//
// Each kind of task has a runner of its own: a class with a constructor, Update and Rejoin, which
// is an alternative of TaskRunner::Runner at the place that the kind has in Task::what. Those of
// underwater vehicles are in auv_task_runners.cc.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "lib/vehicle/guidance/depth_band.h"
#include "lib/vehicle/guidance/leg_follower.h"
#include "lib/vehicle/guidance/path_follower.h"
#include "lib/vehicle/guidance/route_rounds.h"
#include "lib/vehicle/guidance/surroundings.h"
#include "lib/vehicle/guidance/target_tracker.h"
#include "lib/vehicle/guidance/task.h"
#include "lib/vehicle/guidance/turning_room.h"

namespace shoal {

/// Where a vessel is, and when.
struct Fix {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< x East, y North.
  double heading_rad = 0;                                ///< Clockwise from North.
  double time_s = 0;
  double z_m = 0;                                          ///< Depth.
  Eigen::Vector2d velocity_mps = Eigen::Vector2d::Zero();  ///< Over ground.
  double speed_mps = 0;                                    ///< Relative to the water, >= 0.
  int64_t num_gps_fixes = 0;  ///< That its navigation has taken since the start.
  /// What it knows of the others, for underwater tasks with layers; else it may be null. Outlives
  /// the call.
  const Surroundings* surroundings = nullptr;
};

/// What a task asks for, and how far it has come.
struct Guidance {
  double heading_rad = 0;   ///< [0, 2 pi).
  double speed_mps = 0;     ///< Through water, >= 0.
  bool done = false;        ///< The task has nothing left to do.
  int waypoint_index = -1;  ///< -1: the task has no waypoints.
  int laps_done = 0;
  Eigen::Vector2d waypoint_m = Eigen::Vector2d::Zero();  ///< Where it steers for.
  double distance_m = 0;                                 ///< To there.
  double cross_track_error_m = 0;  ///< To starboard of the leg positive; 0 without a leg.
  std::optional<double> z_m = {};  ///< Depth to take; absent: the task knows of none.
  /// Present: the path goes down this fast, and `z_m` with it: it is not to be filtered.
  std::optional<double> z_rate_mps = {};
  std::optional<double> pitch_rad = {};      ///< Present: this pitch, bow up, instead of a depth.
  std::optional<double> propeller_rpm = {};  ///< Present: these revolutions, whatever the speed.
  /// How far ALOS takes the course over ground to lie to starboard of the heading; 0 without ALOS.
  double crab_rad = 0;
  std::vector<LayerShare> layers = {};  ///< Of a cascade of velocities, the most urgent first.
  double u_max_mps = 0;                 ///< The budget that they share.
};

/// Gives the time between updates, none across a pause.
class Stopwatch {
 public:
  explicit Stopwatch(double time_s) : time_s_(time_s) {}
  /// Returns the seconds since the last call, never less than zero.
  double Lap(double time_s);

 private:
  double time_s_;
};

class WaypointsRunner {
 public:
  /// @pre task has a point
  WaypointsRunner(const WaypointsTask& task, const Fix& start);
  Guidance Update(const Fix& fix);
  void Rejoin(const Fix& fix);
  /// Goes on with the points of `task`: those that were passed stay passed.
  void Move(const WaypointsTask& task, const Fix& fix);

 private:
  WaypointsTask task_;
  LegFollower follower_;
  Stopwatch stopwatch_;
  RouteRounds rounds_;
  bool done_ = false;
};

/// Goes round the corners of a regular polygon, the first of which lies North of the centre.
class LoiterRunner {
 public:
  LoiterRunner(const LoiterTask& task, const Fix& start);
  Guidance Update(const Fix& fix);
  void Rejoin(const Fix& fix);

 private:
  LoiterTask task_;
  std::vector<Eigen::Vector2d> corners_m_;  ///< In sailing order.
  RouteRounds rounds_;                      ///< Of the corners.
  LegFollower follower_;
  Stopwatch stopwatch_;
  double elapsed_s_ = 0;
};

/// Drifts until the vessel is outside the outer radius, or has left its depth (depth_band.h), then
/// goes back inside the inner one. With stops_first it first lets the vessel come to rest.
class StationKeepRunner {
 public:
  StationKeepRunner(const StationKeepTask& task, const Fix& start);
  Guidance Update(const Fix& fix);
  void Rejoin(const Fix&) {}

 private:
  StationKeepTask task_;
  Stopwatch stopwatch_;
  Eigen::Vector2d point_m_;
  double heading_rad_;  ///< Kept while it changes its depth close to the point.
  bool has_place_;
  bool is_outside_ = false;  ///< It has left the outer circle, and is not yet in the inner one.
  DepthBand depth_band_;
};

class SurfaceRunner {
 public:
  SurfaceRunner(const SurfaceTask& task, const Fix& start)
      : speed_mps_(task.speed_mps), start_m_(start.position_m), heading_rad_(start.heading_rad) {}
  Guidance Update(const Fix& fix);
  void Rejoin(const Fix& fix) { heading_rad_ = fix.heading_rad; }

 private:
  double speed_mps_;
  Eigen::Vector2d start_m_;
  double heading_rad_;
  bool is_up_ = false;
};

class ReturnRunner {
 public:
  ReturnRunner(const ReturnTask& task, const Fix& start);
  Guidance Update(const Fix& fix);
  void Rejoin(const Fix& fix);

 private:
  ReturnTask task_;
  LegFollower follower_;
  Stopwatch stopwatch_;
  StationKeepRunner keeper_;
  bool arrived_ = false;
};

class PathFollowRunner {
 public:
  /// @pre task has a point
  PathFollowRunner(const PathFollowTask& task, const Fix& start);
  Guidance Update(const Fix& fix);
  void Rejoin(const Fix& fix);

 private:
  Guidance Loiter(const Eigen::Vector3d& center_m, const Fix& fix);

  PathFollowTask task_;
  PathFollower follower_;
  Stopwatch stopwatch_;
  std::optional<LoiterRunner> loiter_;  ///< kLoiter, from the last point on.
  bool keeps_clear_ = false;            ///< Layers steered in the last step.
};

/// Notices that a target which was under water has come to rest at the surface.
class TargetEndWatch {
 public:
  /// Takes note of the surroundings. Returns true while the target rests.
  bool Look(const Surroundings& surroundings, double time_s);
  bool target_rests() const { return rests_; }

 private:
  bool was_deep_ = false;
  bool rests_ = false;
  std::optional<double> differs_since_s_;  ///< Since when the target does otherwise.
};

class TargetTrackRunner {
 public:
  TargetTrackRunner(const TargetTrackTask& task, const Fix& start);
  /// Stands still while nothing is known of the surroundings.
  Guidance Update(const Fix& fix);
  void Rejoin(const Fix&) { wait_.reset(); }

 private:
  /// What it does instead of following.
  enum class Wait { kHold, kSurface };
  using Waiting = std::variant<StationKeepRunner, SurfaceRunner>;

  std::optional<Wait> WaitAt(const Fix& fix);
  Guidance WaitFor(Wait wait, const Fix& fix);
  Guidance Follow(const Fix& fix);
  void AvoidOthers(const Surroundings& surroundings, Guidance* guidance) const;

  TargetTracker tracker_;
  TurningRoom room_;
  TargetTrackTask task_;
  TargetEndWatch end_watch_;
  std::optional<Waiting> wait_;
};

/// Passes the points of a survey like waypoints, once.
class SurveyRunner {
 public:
  /// @pre the task has a lane
  SurveyRunner(const SurveyTask& task, const Fix& start);
  Guidance Update(const Fix& fix) { return points_.Update(fix); }
  void Rejoin(const Fix& fix) { points_.Rejoin(fix); }

 private:
  WaypointsRunner points_;
};

class SurfaceForFixRunner {
 public:
  SurfaceForFixRunner(const SurfaceForFixTask& task, const Fix& start);
  Guidance Update(const Fix& fix);
  void Rejoin(const Fix& fix) { stopwatch_.Lap(fix.time_s); }

 private:
  SurfaceForFixTask task_;
  Stopwatch stopwatch_;
  Eigen::Vector2d start_m_;
  double heading_rad_;
  int64_t num_fixes_before_;
  double elapsed_s_ = 0;
  bool is_up_ = false;
  bool done_ = false;
};

class TaskRunner {
 public:
  using What = decltype(Task::what);

  /// One for each kind, in the order of Task::what.
  using Runner =
      std::variant<WaypointsRunner, LoiterRunner, StationKeepRunner, ReturnRunner, PathFollowRunner,
                   TargetTrackRunner, SurveyRunner, SurfaceRunner, SurfaceForFixRunner>;

  TaskRunner(const What& what, const Fix& start);

  /// Returns the guidance at `fix`. A task that is done stays done.
  /// @pre fix is finite, times do not decrease
  Guidance Update(const Fix& fix);

  /// Goes on after a pause in which something else, or nothing, steered the vessel.
  void Rejoin(const Fix& fix);

  /// Goes on with the same task in other places (moved_task.h). Waypoints that were passed stay
  /// passed; every other kind begins again at `fix`. @pre `what` is of the kind that it began with
  void Move(const What& what, const Fix& fix);

 private:
  Runner runner_;
};

}  // namespace shoal
