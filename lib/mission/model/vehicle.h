// One vehicle of a mission as data, every default filled in: [[vehicle]] and the tables below it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/comms/routing/rules.h"
#include "lib/comms/swarm/recovery.h"
#include "lib/helm/behaviors/any_behavior.h"
#include "lib/helm/decision/domain.h"
#include "lib/helm/modes/mode_tree.h"
#include "lib/helm/modes/variables.h"
#include "lib/mission/model/buoy_model.h"
#include "lib/mission/model/media_options.h"
#include "lib/mission/model/model_facts.h"
#include "lib/mission/model/navigation_options.h"
#include "lib/mission/model/remus100_model.h"
#include "lib/mission/model/surface_craft_model.h"
#include "lib/mission/model/track_model.h"
#include "lib/vehicle/guidance/task.h"

namespace shoal {

/// Where a vehicle begins, and where `reset` takes it back to.
struct StartPose {
  double x_m = 0;          ///< East.
  double y_m = 0;          ///< North.
  double heading_deg = 0;  ///< Clockwise from North.
  double speed_mps = 0;
  double depth_m = 0;  ///< Of underwater vehicles.

  bool operator==(const StartPose&) const = default;
};

/// Where a part of a vehicle (or the broker) comes from.
enum class Provider {
  kShoal,  ///< The launcher starts shoal's own process.
  kHand,   ///< A user starts shoal's process, or one that implements its step protocol.
  kNone,   ///< Not run: the clock does not wait for it.
};

/// `[vehicle.autopilot]` of a surface craft: heading PID to rudder, speed to thrust.
struct AutopilotOptions {
  double heading_kp = 2;                   ///< Degrees of rudder per degree of error.
  double heading_ki = 0.02;                ///< Per degree-second.
  double heading_kd = 0.6;                 ///< Per degree per second.
  double heading_integral_limit_deg = 20;  ///< Of rudder, from the integral term.
  double speed_kp = 5;  ///< Per cent of thrust per m/s of error, on top of the thrust map.
  double speed_ki = 2;
  double speed_integral_limit_pct = 20;

  bool operator==(const AutopilotOptions&) const = default;
};

/// `[vehicle.sensors]`: measurement noise of position and motion. Standard deviations
/// of Gaussian noise, drawn again for every step and each number.
struct SensorOptions {
  bool is_fitted = false;       ///< The file has the table: helm and reports go by MEASURED_NAV.
  double position_noise_m = 0;  ///< Of x and y.
  double depth_noise_m = 0;
  double attitude_noise_deg = 0;     ///< Of heading, pitch and roll.
  double rate_noise_degps = 0;       ///< Of yaw, pitch and roll rate.
  double speed_noise_mps = 0;        ///< Of each component relative to the water and over ground.
  double altitude_noise_m = 0;       ///< Of the altimeter ...
  double altimeter_range_m = 20000;  ///< ... which sees no farther.

  bool operator==(const SensorOptions&) const = default;
};

/// `[vehicle.sonar]`: a fan of beams ahead, as SonarParams (lib/vehicle/sensors) has it.
struct SonarOptions {
  bool is_fitted = false;  ///< The file has the table.
  int azimuth_beams = 11;
  int elevation_beams = 5;
  double max_range_m = 135;
  int range_steps = 27;
  double tilt_deg = 2.5;
  double width_deg = 50;
  double height_deg = 15;
  double rate_hz = 10;
  double noise_m = 0;  ///< Standard deviation of ranges.

  bool operator==(const SonarOptions&) const = default;
};

/// The task of a helm whose tasks are done.
inline constexpr std::string_view kEndOfTasks = "end_of_tasks";

/// `[vehicle.helm_options]`: the helm's own settings.
struct HelmOptions {
  double nav_timeout_s = 2;      ///< All-stop when no NAV came for this long.
  bool deploy_at_start = false;  ///< DRIVE from the first step; otherwise PARK until `deploy`.
  /// Variables that `deploy` leaves as they are.
  std::vector<std::string> deploy_keeps = {};
  double state_interval_s = 1;   ///< HELM_STATE at least this often.
  double decide_every_s = 0.25;  ///< With behaviors: time between decisions, in whole steps.
  bool goals_mandatory = false;  ///< Constraints alone (avoidance, limits) stop the vehicle.
  /// Absent: kHold; of a vehicle whose last task brought it to the surface kSurface.
  std::optional<Ending> end_of_tasks = {};
  double hold_radius_m = 10;    ///< Keeping station by order or at the end: comes back from beyond.
  double loiter_radius_m = 50;  ///< Of kLoiter.

  bool operator==(const HelmOptions&) const = default;
};

/// `[vehicle.reporter]`, after pNodeReporter.
struct ReporterOptions {
  double rate_hz = 2;              ///< Reports per second of mission time.
  double nav_grace_period_s = 60;  ///< No warning for missing NAV before this.
  double nohelm_threshold_s = 5;   ///< Mode becomes NOHELM-<s> after this.
  double blackout_interval_s = 0;  ///< At least this between reports; 0: off.
  double blackout_variance_s = 0;  ///< Uniformly random addition in +- this.
  bool extrapolate = false;        ///< Skip a report that dead reckoning predicts.
  double extrap_position_thresh_m = 0.25;
  double extrap_heading_thresh_deg = 1;
  double extrap_max_gap_s = 5;               ///< But never stay silent longer than this.
  std::map<std::string, std::string> extra;  ///< The user's own fields, sent with every report.

  bool operator==(const ReporterOptions&) const = default;
};

/// `[vehicle.messages]`: how the vehicle's own messages are repeated until they are acknowledged.
struct MessageOptions {
  double ack_timeout_s = 30;  ///< Time to wait for an ack before each repeat.
  int64_t max_repeats = 3;    ///< Then it is given up.
  /// An ack waits for up to this, a repeat for up to that in addition, drawn for each: senders
  /// whose packets would meet again and again drift apart.
  double ack_jitter_s = 1;
  double repeat_jitter_s = 5;

  bool operator==(const MessageOptions&) const = default;
};

/// One alternative for each vehicle model, the default first: its parameters, of which FactsOf
/// knows the rest. CONTRIBUTING.md has the recipe for a new one.
using AnyModel = std::variant<SurfaceCraftParams, Remus100Options, BuoyParams, TrackOptions>;

struct Vehicle {
  // Defined once, in vehicle.cc: each takes a second to compile.
  Vehicle();
  ~Vehicle();
  Vehicle(const Vehicle&);
  Vehicle(Vehicle&&) noexcept;
  Vehicle& operator=(const Vehicle&);
  Vehicle& operator=(Vehicle&&) noexcept;

  std::string name;
  std::string type = "kayak";
  AnyModel model;  ///< How it moves.
  std::string group;
  std::string color = "yellow";
  double length_m = 3;
  double draught_m = 0.3;  ///< Of what floats at the surface: DraughtOf.
  StartPose start;
  SensorOptions sensors;
  NavigationOptions navigation;
  SonarOptions sonar;
  bool is_outside = false;               ///< `outside = true`: all four of these are kNone.
  Provider sim = Provider::kShoal;       ///< `vehicle_sim = "shoal" | "hand" | "none"`
  Provider helm = Provider::kShoal;      ///< `helm = ...`
  Provider reporter = Provider::kShoal;  ///< `node_reporter = ...`
  Provider acomms = Provider::kShoal;    ///< `acomms = ...`, of vehicles in the swarm.
  HelmOptions helm_options;
  AutopilotOptions autopilot;  ///< Of surface craft; other models have their own.
  ReporterOptions reporter_options;
  MessageOptions message_options;
  LinkFactors link_factors;                ///< `stealth`, `earange`
  VehicleMedia media;                      ///< `media`, `antenna_height_m`, `[vehicle.gateway]`
  int acoustic_address = 0;                ///< In the acoustic network; always > 0 once loaded.
  bool acoustic_leader = false;            ///< tdma_lf: it leads.
  double modem_depth_m = 0;                ///< Its acoustic modem hangs so far below it; >= 0.
  RecoveryPlan recovery;                   ///< Of messages of the swarm.
  std::vector<Task> tasks;                 ///< Done in this order after `deploy`; then the ending.
  ReturnTask return_task;                  ///< What `return` does. Default: the start position.
  std::vector<BehaviorOptions> behaviors;  ///< Beside the task of the moment.
  std::vector<ModeOptions> modes;          ///< Evaluated in this order.
  std::map<std::string, VariableValue> variables;  ///< Of conditions and flags, at the start.
  Domain domain;                                   ///< What the behaviors decide about.

  bool operator==(const Vehicle&) const;

  /// True where it can send and receive by this medium; where the mission has no media of its own,
  /// by all.
  bool HasMedium(std::string_view medium) const;
};

/// Returns how deep its keel lies below its position: 0 for what dives or is moored.
[[nodiscard]] double DraughtOf(const Vehicle& vehicle);

[[nodiscard]] ModelFacts FactsOfModel(const AnyModel& model);

/// Returns each model with its default parameters, in the order of AnyModel.
[[nodiscard]] std::vector<AnyModel> EachModel();

}  // namespace shoal
