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

#include "lib/guidance/leg_follower.h"
#include "lib/guidance/path_follower.h"
#include "lib/guidance/surroundings.h"
#include "lib/guidance/target_tracker.h"
#include "lib/guidance/task.h"

namespace shoal {

/// Where a vessel is, and when.
struct Fix {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< x East, y North.
  double heading_rad = 0;                                ///< Clockwise from North.
  double time_s = 0;
  double z_m = 0;             ///< Depth.
  int64_t num_gps_fixes = 0;  ///< That its navigation has taken since the start.
  /// What it knows of the others, for target_track; else it may be null. Outlives the call.
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
  double cross_track_error_m = 0;            ///< To starboard of the leg positive; 0 without a leg.
  std::optional<double> z_m = {};            ///< Depth to take; absent: the task knows of none.
  std::optional<double> pitch_rad = {};      ///< Present: this pitch, bow up, instead of a depth.
  std::optional<double> propeller_rpm = {};  ///< Present: these revolutions, whatever the speed.
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

 private:
  WaypointsTask task_;
  LegFollower follower_;
  Stopwatch stopwatch_;
  size_t next_ = 0;  ///< The point steered for.
  int laps_done_ = 0;
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
  size_t next_;                             ///< The corner steered for.
  LegFollower follower_;
  Stopwatch stopwatch_;
  double elapsed_s_ = 0;
  int corners_passed_ = 0;
};

/// Drifts until the vessel is outside the outer radius, then goes back inside the inner one.
class StationKeepRunner {
 public:
  StationKeepRunner(const StationKeepTask& task, const Fix& start);
  Guidance Update(const Fix& fix);
  void Rejoin(const Fix&) {}

 private:
  StationKeepTask task_;
  Eigen::Vector2d point_m_;
  bool goes_back_ = false;
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
  void Rejoin(const Fix& fix) { stopwatch_.Lap(fix.time_s); }

 private:
  PathFollowTask task_;
  PathFollower follower_;
  Stopwatch stopwatch_;
};

class TargetTrackRunner {
 public:
  TargetTrackRunner(const TargetTrackTask& task, const Fix& start);
  /// Stands still while nothing is known of the surroundings.
  Guidance Update(const Fix& fix);
  void Rejoin(const Fix&) { silence_.reset(); }

 private:
  /// Where it was when the target fell silent, and what keeps it there.
  struct Silence {
    double heading_rad = 0;
    double z_m = 0;
    StationKeepRunner keeper;
  };

  Guidance Follow(const Fix& fix);
  Guidance WaitFor(const Fix& fix);
  void AvoidOthers(const Surroundings& surroundings, Guidance* guidance) const;

  TargetTracker tracker_;
  bool compensate_current_;
  SilenceRule on_silence_;
  std::optional<Silence> silence_;
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
                   TargetTrackRunner, SurveyRunner, SurfaceForFixRunner>;

  TaskRunner(const What& what, const Fix& start);

  /// Returns the guidance at `fix`. A task that is done stays done.
  /// @pre fix is finite, times do not decrease
  Guidance Update(const Fix& fix);

  /// Goes on after a pause in which something else, or nothing, steered the vessel.
  void Rejoin(const Fix& fix);

 private:
  Runner runner_;
};

}  // namespace shoal
