// A behavior as data: what every one has, and the options of its kind.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/helm/behaviors/avoid_collision.h"
#include "lib/helm/behaviors/avoid_obstacle.h"
#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/colregs.h"
#include "lib/helm/behaviors/constant_depth.h"
#include "lib/helm/behaviors/constant_heading.h"
#include "lib/helm/behaviors/constant_speed.h"
#include "lib/helm/behaviors/convoy.h"
#include "lib/helm/behaviors/cut_range.h"
#include "lib/helm/behaviors/fixed_turn.h"
#include "lib/helm/behaviors/full_stop.h"
#include "lib/helm/behaviors/go_to_depth.h"
#include "lib/helm/behaviors/heading_bias.h"
#include "lib/helm/behaviors/hysteresis.h"
#include "lib/helm/behaviors/leg_run.h"
#include "lib/helm/behaviors/loiter.h"
#include "lib/helm/behaviors/maintain_heading.h"
#include "lib/helm/behaviors/max_depth.h"
#include "lib/helm/behaviors/max_speed.h"
#include "lib/helm/behaviors/memory_turn_limit.h"
#include "lib/helm/behaviors/min_altitude.h"
#include "lib/helm/behaviors/op_region.h"
#include "lib/helm/behaviors/periodic_speed.h"
#include "lib/helm/behaviors/periodic_surface.h"
#include "lib/helm/behaviors/rubber_band.h"
#include "lib/helm/behaviors/shadow.h"
#include "lib/helm/behaviors/station_keep.h"
#include "lib/helm/behaviors/test_failure.h"
#include "lib/helm/behaviors/timer.h"
#include "lib/helm/behaviors/trail.h"
#include "lib/helm/behaviors/waypoint.h"
#include "lib/helm/behaviors/zigzag.h"

namespace shoal {

/// One alternative for each kind of behavior.
using AnyBehavior =
    std::variant<WaypointOptions, LoiterOptions, StationKeepOptions, AvoidCollisionOptions,
                 ConstantDepthOptions, ColregsOptions, ConstantSpeedOptions, ConstantHeadingOptions,
                 AvoidObstacleOptions, TimerOptions, PeriodicSurfaceOptions, TrailOptions,
                 MaxDepthOptions, MaxSpeedOptions, CutRangeOptions, ConvoyOptions, GoToDepthOptions,
                 LegRunOptions, OpRegionOptions, MemoryTurnLimitOptions, PeriodicSpeedOptions,
                 ShadowOptions, FixedTurnOptions, ZigzagOptions, FullStopOptions,
                 TestFailureOptions, MaintainHeadingOptions, HeadingBiasOptions, HysteresisOptions,
                 MinAltitudeOptions, RubberBandOptions>;

/// Where behaviors for contacts and updates of new names come from.
enum class Templating {
  kNone,   ///< One behavior, from the start.
  kSpawn,  ///< A recipe: one behavior for each contact, or name in an update.
  kClone,  ///< As kSpawn, and one from the start.
};

/// "VARIABLE = value" lists that fire at certain moments, as written in the mission file.
struct BehaviorFlags {
  std::vector<std::string> runflag = {};
  std::vector<std::string> runxflag = {};
  std::vector<std::string> idleflag = {};
  std::vector<std::string> activeflag = {};
  std::vector<std::string> inactiveflag = {};
  std::vector<std::string> endflag = {};
  std::vector<std::string> spawnflag = {};
  std::vector<std::string> spawnxflag = {};
  std::vector<std::string> configflag = {};

  bool operator==(const BehaviorFlags&) const = default;
};

/// [[vehicle.behavior]].
struct BehaviorOptions {
  std::string name;
  double pwt = 100;  ///< Priority weight; >= 0.
  std::vector<std::string> condition = {};
  BehaviorFlags flags = {};
  std::string updates = {};             ///< A variable; empty: no updates.
  std::optional<double> duration = {};  ///< Seconds of running; absent: without end.
  bool duration_idle_decay = true;
  std::string duration_reset = {};         ///< VARIABLE, or VARIABLE = value.
  std::string duration_status = {};        ///< A variable.
  std::vector<std::string> nostarve = {};  ///< Variables ...
  double nostarve_s = 0;                   ///< ... and their greatest age.
  bool perpetual = false;
  Templating templating = Templating::kNone;
  int max_spawnings = 1000;
  AnyBehavior what = WaypointOptions();

  bool operator==(const BehaviorOptions&) const = default;
};

/// Returns the word of mission files for the kind.
[[nodiscard]] std::string_view KindOf(const AnyBehavior& what);

/// Returns each kind with its defaults, in the order of AnyBehavior.
[[nodiscard]] std::vector<AnyBehavior> OneBehaviorOfEachKind();

/// Starts a behavior.
[[nodiscard]] std::unique_ptr<Behavior> MakeBehavior(const BehaviorOptions& options);

/// Gives `behavior` new options of its kind.
/// @pre behavior was made of options with the same alternative
void Reconfigure(Behavior& behavior, const AnyBehavior& what);

/// Returns the contact that a contact behavior is about, nullptr for other kinds: spawning fills it
/// in.
[[nodiscard]] std::string* ContactOf(AnyBehavior& what);

}  // namespace shoal
