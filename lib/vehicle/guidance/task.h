// The tasks of a helm as data: one struct for every kind. A new kind is a struct here with its
// kKind, one more alternative of Task::what and one FactsOf in task.cc; CONTRIBUTING.md has the
// whole recipe.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/vehicle/guidance/path_parts.h"
#include "lib/vehicle/guidance/path_progress.h"
#include "lib/vehicle/guidance/survey_lanes.h"
#include "lib/vehicle/guidance/target_tracker.h"

namespace shoal {

/// How a waypoint counts as reached; the first that holds decides.
struct CaptureRule {
  double capture_radius_m = 5;  ///< Closer than this. > 0.
  double slip_radius_m = 15;    ///< Closer than this and the distance grows again; 0: off.
  bool capture_line = false;    ///< Past the line through the point, square to the leg.

  bool operator==(const CaptureRule&) const = default;
};

/// Follows the legs between points.
struct WaypointsTask {
  static constexpr std::string_view kKind = "waypoints";

  std::vector<Eigen::Vector2d> points_m;  ///< x East, y North; at least one.
  double speed_mps = 1.5;
  CaptureRule capture = {};
  int laps = 1;              ///< How often the points are passed; 0: for ever.
  double lookahead_m = 15;   ///< ALOS look-ahead distance; > 0.
  double crab_gain = 0.005;  ///< ALOS adaptation gain gamma (Fossen 2023); 0: plain LOS.

  bool operator==(const WaypointsTask&) const = default;
};

/// Circles a point on a regular polygon.
struct LoiterTask {
  static constexpr std::string_view kKind = "loiter";

  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double radius_m = 50;  ///< Of the circumscribed circle; > 0.
  int num_points = 8;    ///< At least 3.
  bool clockwise = true;
  double speed_mps = 1.5;
  CaptureRule capture = {};
  double lookahead_m = 15;
  double crab_gain = 0.005;
  double duration_s = 0;           ///< Then the task is done, the way there included; 0: for ever.
  std::optional<double> z_m = {};  ///< Depth to take; absent: the task knows of none.

  bool operator==(const LoiterTask&) const = default;
};

/// Stays near a point: drifts inside the inner radius, returns when outside the outer. A vehicle
/// needs room to come about: one that turns in a circle goes beyond the outer radius by about the
/// circle's diameter.
struct StationKeepTask {
  static constexpr std::string_view kKind = "station_keep";

  Eigen::Vector2d point_m = Eigen::Vector2d::Zero();
  bool here = true;  ///< Keep the place where the task starts, instead of point_m.
  double inner_radius_m = 4;
  double outer_radius_m = 10;  ///< > inner_radius_m.
  double speed_mps = 1.0;
  bool stops_first = false;  ///< `here` is where it has come to rest.
  /// Depth to keep, within 1 m: it swims back to it. Absent: the task knows of none.
  std::optional<double> z_m = {};

  bool operator==(const StationKeepTask&) const = default;
};

/// Goes home and stays there.
struct ReturnTask {
  static constexpr std::string_view kKind = "return";

  Eigen::Vector2d point_m = Eigen::Vector2d::Zero();
  double speed_mps = 1.5;
  CaptureRule capture = {};
  double outer_radius_m = 10;      ///< Home, it keeps station inside this radius.
  std::optional<double> z_m = {};  ///< Depth to go at and to keep. Absent: it knows of none.

  bool operator==(const ReturnTask&) const = default;
};

/// Passes parallel lanes over a polygon, or over one vehicle's share of it.
struct SurveyTask {
  static constexpr std::string_view kKind = "survey";

  SurveyArea area;
  SurveyRoute route;
  SurveyShare share;  ///< Follows from divide_among.
  std::vector<std::string>
      divide_among;  ///< Vehicles and "group:NAME"; empty: all of it is its own.
  double speed_mps = 1.5;
  CaptureRule capture = {};
  double lookahead_m = 15;
  double crab_gain = 0.005;

  bool operator==(const SurveyTask&) const = default;
};

/// Comes up where it is and waits for GPS; for underwater vehicles with [vehicle.navigation].
struct SurfaceForFixTask {
  static constexpr std::string_view kKind = "surface_for_fix";

  int fixes = 10;        ///< It waits for this many, then the task is done; > 0 ...
  double limit_s = 300;  ///< ... or when this is over since it began; > 0.
  double speed_mps = 2;  ///< > 0: fins need it.
  double radius_m = 20;  ///< Of the circle that it goes at the surface; > 0.

  bool operator==(const SurfaceForFixTask&) const = default;
};

/// Comes up on the heading that it has, and drifts at the surface with its propeller off; for
/// underwater vehicles. Done at the surface.
struct SurfaceTask {
  static constexpr std::string_view kKind = "surface";

  double speed_mps = 1.5;

  bool operator==(const SurfaceTask&) const = default;
};

/// Where a vehicle's knowledge of its swarm comes from.
enum class SwarmKnowledge {
  kDirect,    ///< The true state of every vehicle, a step old.
  kAcoustic,  ///< What the acoustic network let through, and what is predicted from that.
};

/// What comes after the last point of a path_follow task.
enum class PathTaskEnd {
  kDone,           ///< The task is done; the next of the list follows.
  kGoOn,           ///< Keeps course and depth, for ever.
  kHold,           ///< Keeps station at the last point, at its depth; for ever.
  kReturnToFirst,  ///< Follows the path again, for ever.
  kSurface,        ///< Comes up on the last leg's course; done at the surface.
  kLoiter,         ///< Circles the last point at its depth, for ever.
};

/// Follows the legs between points in three dimensions; for underwater vehicles.
struct PathFollowTask {
  static constexpr std::string_view kKind = "path_follow";

  std::vector<Eigen::Vector3d> points_m;  ///< x East, y North, z down; empty where there are parts.
  std::vector<PathPart> parts = {};       ///< Instead: the path is joined of these.
  PathStart start = {};      ///< Of the vehicle: where the first part begins that names no place.
  double turn_radius_m = 0;  ///< Corners become arcs of this radius; 0: they stay.
  bool approach = true;      ///< PathFollowParams has the meanings.
  DepthRule depth_rule = DepthRule::kNext;
  double speed_mps = 2;
  double propeller_rpm = 0;  ///< More than 0: this, instead of what speed_mps takes.
  WaypointSwitch waypoint_switch = {};
  PathTaskEnd end = PathTaskEnd::kDone;
  double lookahead_m = 10;    ///< ALOS look-ahead distance; > 0.
  double crab_gain = 0.0006;  ///< ALOS adaptation gain gamma; 0: plain LOS.
  bool guard_crab = true;     ///< PathFollowParams has the meanings.
  bool turn_crab = true;
  double hold_radius_m = 30;    ///< kHold: comes back from beyond; >= the acceptance radius.
  double loiter_radius_m = 50;  ///< kLoiter; > 0.
  /// Layers above the way to the waypoint, the most urgent first; none: it follows its path,
  /// whatever is there.
  VelocityCascade cascade = {.layers = {}};
  double u_max_mps = 2.5;                          ///< The budget of the layers.
  std::vector<std::string> group = {};             ///< Empty: all other underwater vehicles.
  SwarmKnowledge swarm = SwarmKnowledge::kDirect;  ///< Of the group.

  bool operator==(const PathFollowTask&) const = default;
};

/// What a follower does while its target is silent.
enum class SilenceRule {
  kPredict,      ///< Follows where the target is expected to be.
  kStationKeep,  ///< Stays where it is, at its depth.
  kSurface,      ///< Comes up, and stays there.
};

/// What a follower does when its target, which was under water, rests at the surface. It follows
/// again when the target moves.
enum class TargetEndRule {
  kSurface,  ///< Comes up, and drifts there clear of the others.
  kHold,     ///< Keeps station where it is, at its depth.
  kGoOn,     ///< Goes on following, as MuNet does: it stays z_safe below the surface.
  kDone,     ///< The task is done; the next of the list follows.
};

/// Follows a leader, in formation or by constant bearing; for underwater vehicles.
struct TargetTrackTask {
  static constexpr std::string_view kKind = "target_track";

  std::string target;              ///< The vehicle that is followed.
  std::vector<std::string> group;  ///< Those to keep clear of; empty: all that follow the target.
  SwarmKnowledge swarm = SwarmKnowledge::kDirect;
  SilenceRule on_silence = SilenceRule::kPredict;  ///< kAcoustic.
  /// kAcoustic: where the next message puts the target elsewhere than expected, what is steered for
  /// goes there at this speed. 0: at once, MuNet's.
  double smoothing_mps = 1;
  TargetEndRule on_target_end = TargetEndRule::kSurface;
  double hold_radius_m = 45;  ///< Where it keeps station: comes back from beyond; > 0.
  /// Steers so that the velocity over ground is what the law wants. False: ignores the current, as
  /// MuNet does.
  bool compensate_current = true;
  /// Asks the propeller for the part of the wanted velocity along the bow: less in a turn, nothing
  /// where it would have to go astern. False: for all of it, wherever the bow points, MuNet's.
  bool speed_along_bow = true;
  /// By default layers for the group, the formation and the target's motion.
  TargetTrackParams track = {
      .law = VelocityCascade{{SurvivalGroupLayer{}, FormationLayer{}, FeedForwardLayer{}}},
      .depth = {.climb_mps = 0.5}};

  bool operator==(const TargetTrackTask&) const = default;
};

/// What a vehicle does when its tasks are done.
enum class Ending {
  kHold,        ///< Keeps station where it has come to rest, at its depth.
  kSurface,     ///< Comes up, and drifts at the surface with its propeller off.
  kGoOn,        ///< Keeps course, speed and depth.
  kLoiter,      ///< Circles the place where it is, at its depth.
  kEndMission,  ///< The mission ends, when all vehicles with this ending are done.
};

/// A named task of a vehicle's list.
struct Task {
  std::string name;
  std::variant<WaypointsTask, LoiterTask, StationKeepTask, ReturnTask, PathFollowTask,
               TargetTrackTask, SurveyTask, SurfaceTask, SurfaceForFixTask>
      what;
  double pwt = 100;  ///< Priority weight beside behaviors; >= 0.

  bool operator==(const Task&) const = default;
};

/// A task as it is drawn.
struct TaskOutline {
  struct Circle {
    Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
    double radius_m = 0;
  };

  std::vector<Eigen::Vector2d> points_m = {};  ///< In the order of HELM_STATE's waypoint_index.
  bool closed = false;                         ///< A leg leads from the last point to the first.
  double radius_m = 0;                         ///< Around each point; 0: none.
  std::optional<Circle> circle = {};           ///< The points lie on it.
  std::vector<Eigen::Vector2d> area_m = {};    ///< Corners of the polygon that it is about.
  bool marks_points = true;                    ///< False: most points only shape a turn.
};

/// What checks, pages and plots must know of a task.
struct TaskFacts {
  bool is_underwater = false;  ///< Only a vehicle whose model dives can do it.
  bool ends = false;           ///< It is done at some time; then the next of the list follows.
  /// How often its points can be passed, 0: it has none that count; absent: without limit.
  std::optional<int64_t> most_laps = {};
  TaskOutline outline = {};
};

/// Returns the task that keeps station at the place where the vehicle stops, at the depth `z_m`.
/// The vehicle comes back when it is farther away than `radius_m`, > 0, within which it can circle.
[[nodiscard]] StationKeepTask HoldHere(double radius_m, std::optional<double> z_m);

/// Returns the mission file's word for the kind of the task: its kKind.
std::string_view KindOf(const Task& task);

[[nodiscard]] TaskFacts FactsOf(const Task& task);

/// Returns one task of each kind with its defaults, in the order of Task::what; without a name.
[[nodiscard]] std::vector<Task> OneTaskOfEachKind();

/// Returns the corners of the polygon in the order in which they are passed, the first one North of
/// the centre.
[[nodiscard]] std::vector<Eigen::Vector2d> CornersOf(const LoiterTask& task);

/// Returns the path that the task follows: its points or joined parts, corners made round.
[[nodiscard]] JoinedPath PathOf(const PathFollowTask& task);

/// Returns the points of the task's own lanes and of the turns between them, in the order in which
/// they are passed; nothing where it has no polygon.
[[nodiscard]] std::vector<Eigen::Vector2d> PointsOf(const SurveyTask& task);

}  // namespace shoal
