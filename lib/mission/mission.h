// A mission as data, every default filled in. lib/mission/load.h makes one from a file;
// docs/mission_file.md tells what each key means to a user.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/acoustics/acoustic_options.h"
#include "lib/guidance/task.h"
#include "lib/netsim/netsim_options.h"
#include "lib/routing/fate.h"
#include "lib/routing/rules.h"
#include "lib/swarm/recovery.h"
#include "lib/vehicle/surface_craft.h"

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
  kHand,   ///< Somebody starts shoal's process, or one that speaks its step protocol, by hand.
  kNone,   ///< Nobody: the clock does not wait for it.
};

/// `[vehicle.autopilot]`: heading PID to rudder, speed to thrust.
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

/// `[vehicle.remus100]`: the underwater vehicle and its autopilots.
struct Remus100Options {
  std::string parameters = "default";  ///< default, munet or fossen: docs/vehicles.md.
  double model_step_s = 0.02;          ///< The longest step of integration within a tick.
  double cruise_depth_m = 0;           ///< Of tasks that know of no depth.
  double max_depth_m = 100;
  double seabed_clearance_m = 5;
  double depth_filter_s = 20;           ///< Time constant of the commanded depth; 0: one step.
  double max_propeller_rate_rpmps = 0;  ///< 0: the propeller is told at once.

  bool operator==(const Remus100Options&) const = default;
};

/// `[vehicle.sensors]`: how badly the vehicle measures where it is and how it moves. Standard
/// deviations of Gaussian noise, drawn anew for every step and each number.
struct SensorOptions {
  bool is_fitted = false;       ///< The file has the table: helm and reports go by MEASURED_NAV.
  double position_noise_m = 0;  ///< Of x and y.
  double depth_noise_m = 0;
  double attitude_noise_deg = 0;     ///< Of heading, pitch and roll.
  double rate_noise_degps = 0;       ///< Of yaw, pitch and roll rate.
  double speed_noise_mps = 0;        ///< Of each component through the water and over ground.
  double altitude_noise_m = 0;       ///< Of the altimeter ...
  double altimeter_range_m = 20000;  ///< ... which sees no farther.

  bool operator==(const SensorOptions&) const = default;
};

/// `[vehicle.sonar]`: a fan of beams ahead, as SonarParams (lib/sensors) has it.
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

/// `[vehicle.helm_options]`: the helm's own settings.
struct HelmOptions {
  double nav_timeout_s = 2;      ///< All-stop when no NAV came for this long.
  bool deploy_at_start = false;  ///< DRIVE from the first step; otherwise PARK until `deploy`.
  double state_interval_s = 1;   ///< HELM_STATE at least this often.

  bool operator==(const HelmOptions&) const = default;
};

/// `[vehicle.reporter]`, after pNodeReporter.
struct ReporterOptions {
  double rate_hz = 2;              ///< Reports per second of mission time.
  double nav_grace_period_s = 60;  ///< No warning for missing NAV before this.
  double nohelm_threshold_s = 5;   ///< Mode becomes NOHELM-<s> after this.
  double blackout_interval_s = 0;  ///< At least this between reports; 0: off.
  double blackout_variance_s = 0;  ///< Uniformly random addition in +- this.
  bool extrapolate = false;        ///< Skip a report that dead reckoning foretells.
  double extrap_position_thresh_m = 0.25;
  double extrap_heading_thresh_deg = 1;
  double extrap_max_gap_s = 5;               ///< But never stay silent longer than this.
  std::map<std::string, std::string> extra;  ///< The user's own fields, sent with every report.

  bool operator==(const ReporterOptions&) const = default;
};

/// `[vehicle.messages]`: how the vehicle's own messages are repeated until they are acknowledged.
struct MessageOptions {
  double ack_timeout_s = 30;  ///< So long an ack is waited for before each repeat.
  int64_t max_repeats = 3;    ///< Then it is given up.

  bool operator==(const MessageOptions&) const = default;
};

struct Vehicle {
  std::string name;
  std::string type = "kayak";
  std::string model = "surface_craft";  ///< Or "remus100".
  std::string group;
  std::string color = "yellow";
  double length_m = 3;
  StartPose start;
  SurfaceCraftParams surface_craft;
  Remus100Options remus100;
  SensorOptions sensors;
  SonarOptions sonar;
  Provider sim = Provider::kShoal;       ///< `vehicle_sim = "shoal" | "hand" | "none"`
  Provider helm = Provider::kShoal;      ///< `helm = ...`
  Provider reporter = Provider::kShoal;  ///< `node_reporter = ...`
  Provider acomms = Provider::kShoal;    ///< `acomms = ...`, of vehicles in the swarm.
  HelmOptions helm_options;
  AutopilotOptions autopilot;
  ReporterOptions reporter_options;
  MessageOptions message_options;
  LinkFactors link_factors;      ///< `stealth`, `earange`
  int acoustic_address = 0;      ///< In the acoustic network; always > 0 once loaded.
  bool acoustic_leader = false;  ///< tdma_lf: it leads.
  RecoveryPlan recovery;         ///< Of messages of the swarm.
  std::vector<Task> tasks;       ///< Done in this order after `deploy`; then station keeping.
  ReturnTask return_task;        ///< What `return` does. Default: the start position.

  bool operator==(const Vehicle&) const = default;
};

/// `[environment.current]`: each a number, two numbers ("0.1..0.4") from which one is drawn, or the
/// name of a zone (lib/ocean/current_zones.h).
struct CurrentWords {
  std::string speed_mps = "0";
  std::string direction_deg = "0";  ///< Toward which it flows, clockwise from North.
  std::string speed_deviation_mps = "0";
  std::string direction_deviation_deg = "0";
  std::string speed_half_period_s = "60";
  std::string direction_half_period_s = "60";

  bool operator==(const CurrentWords&) const = default;
};

/// `[environment.floor]`.
struct FloorOptions {
  std::string style = "none";  ///< none, flat, linear, sigmoid, shelf or grid.
  double depth_m = 125;        ///< The least.
  double range_m = 10;         ///< How much deeper it gets.
  double size_m = 1000;        ///< The map's side; its middle is the mission's origin.
  double scale_m = 300;        ///< From hill to hill, about.
  double slope_east = 0;       ///< Metres deeper per metre.
  double slope_north = 0;
  std::string grid;            ///< grid: the path of an ESRI ASCII file.
  bool grid_is_depth = false;  ///< Its numbers are depths; else elevations.
  Eigen::Vector2d grid_origin_m = Eigen::Vector2d::Zero();  ///< The mission's origin in the grid.

  bool operator==(const FloorOptions&) const = default;
};

/// What two vehicles do that come nearer than the mean of their lengths.
enum class ContactRule {
  kIgnore,  ///< They pass through each other.
  kStop,    ///< Both stand still from then on.
};

/// `[environment.plume]`: pollution that leaks from a point.
struct PlumeOptions {
  bool exists = false;  ///< The file has the table.
  Eigen::Vector3d source_m = {0, 0, 30};
  double rate_gps = 1.59;
  double current_mps = 1.5;
  double direction_deg = 90;  ///< Toward which it drifts, clockwise from North.

  bool operator==(const PlumeOptions&) const = default;
};

/// `[environment]`.
struct Environment {
  CurrentWords current;
  FloorOptions floor;
  PlumeOptions plume;
  ContactRule contact = ContactRule::kIgnore;

  bool operator==(const Environment&) const = default;
};

/// `[acoustics]`: the acoustic network, which carries what `reports_over` and `messages_over` say,
/// and ACOUSTIC_TX always.
struct Acoustics {
  /// The mission means to use it: it has the table, or traffic that goes over it. Only then must
  /// there be a channel for each vehicle.
  bool is_used = false;
  bool crc = true;  ///< Four more bytes on the air, by which damage is found and thrown away.
  AcousticOptions options;

  bool operator==(const Acoustics&) const = default;
};

/// `[swarm]`: how a leader and its followers tell each other where they are, through the water.
/// Lengths of time below 0 are "auto": lib/mission/swarm_plan.h finds them.
struct SwarmOptions {
  bool exists = false;                 ///< The file has the table.
  std::string leader;                  ///< A vehicle.
  std::vector<std::string> followers;  ///< In the order of their slots, without the leader.
  std::string scheduler = "auto";      ///< fdma_lf, tdma, tdma_lf; auto: by the access mode.
  double episode_s = -1;
  double offset_s = -1;          ///< fdma_lf, tdma: from one member's slot to the next.
  double broadcast_s = -1;       ///< tdma_lf: from the request to the first answer.
  double response_s = -1;        ///< tdma_lf: from one answer to the next.
  double max_distance_m = 1000;  ///< No two members are ever farther apart.
  bool frames = false;           ///< A sequence number and a checksum with each message.
  std::string group_id = "A";    ///< One letter or digit, sent with each message.
  double silent_after_s = 60;    ///< Who was not heard for so long is shown as silent.

  bool operator==(const SwarmOptions&) const = default;
};

/// `[[event]]`: at a time, something is said.
struct CommandEvent {
  std::string vehicle;  ///< A name, or "all".
  std::string command;  ///< A helm command: see helm_command_t.
  std::string argument;
  std::vector<double> values;

  bool operator==(const CommandEvent&) const = default;
};
struct SimCommandEvent {
  std::string vehicle;
  std::string command;  ///< See sim_command_t.
  std::vector<double> values;

  bool operator==(const SimCommandEvent&) const = default;
};
struct RuleEvent {
  std::string rule;     ///< One of ControlTable(): "comms_range", "stealth", ...
  std::string vehicle;  ///< Where the rule is of one vehicle; otherwise empty.
  double value = 0;     ///< true and false are 1 and 0; a request has none.

  bool operator==(const RuleEvent&) const = default;
};
struct MessageEvent {  ///< A vehicle sends a node message: see node_message_t.
  std::string src_node;
  std::string dest_node;   ///< Names joined by ':', or all.
  std::string dest_group;  ///< A group, or all.
  std::string var_name;
  std::string string_val;
  std::optional<double> double_val;  ///< Present: the value, and string_val is empty.
  bool ack = false;                  ///< Repeated until it is acknowledged.

  bool operator==(const MessageEvent&) const = default;
};
struct Event {
  double at_s = 0;  ///< Mission seconds since the start.
  std::variant<CommandEvent, SimCommandEvent, RuleEvent, MessageEvent> what;

  bool operator==(const Event&) const = default;
};

/// `[[participant]]`: a user's own process that takes part in stepping.
struct Participant {
  std::string name;
  std::vector<std::string> command;  ///< Started by the launcher; empty: by hand.

  bool operator==(const Participant&) const = default;
};

/// `[[expect]]`: what the mission must achieve. `vehicle` may be "all": each of them.
struct ArrivalExpectation {  ///< kind = "arrival"
  std::string vehicle;
  std::optional<Eigen::Vector2d> point_m;  ///< Absent: the vehicle's return point.
  double within_m = 20;
  double by_s = 0;     ///< It is there at some time not later than this ...
  bool stays = false;  ///< ... and from then on to the end.

  bool operator==(const ArrivalExpectation&) const = default;
};
struct SeparationExpectation {  ///< kind = "separation": no two vehicles ever closer.
  double min_m = 0;

  bool operator==(const SeparationExpectation&) const = default;
};
struct CommsExpectation {  ///< kind = "reports", "messages", "acks" or "packets": what became of
                           ///< them.
  Kind kind = Kind::kReport;
  std::string from = "all";
  std::string to = "all";
  std::string cause = "delivered";  ///< A fate's cause.
  std::optional<int64_t> at_least = std::nullopt;
  std::optional<int64_t> at_most = std::nullopt;
  std::optional<double> at_least_pct = std::nullopt;  ///< Of all fates of these links.
  std::optional<double> at_most_pct = std::nullopt;

  bool operator==(const CommsExpectation&) const = default;
};
struct SwarmExpectation {  ///< kind = "swarm": what became of the messages that members heard.
  std::string from = "all";
  std::string to = "all";
  std::string outcome = "clean";                      ///< clean, recovered or rejected.
  std::optional<double> at_least_pct = std::nullopt;  ///< Of what was received.
  std::optional<double> at_most_pct = std::nullopt;

  bool operator==(const SwarmExpectation&) const = default;
};
struct HelmExpectation {  ///< kind = "helm": the helm's state at the end.
  std::string vehicle;
  std::string state;  ///< PARK, DRIVE or ALL-STOP; empty: any.
  std::string task;   ///< Name of the running task; empty: any.

  bool operator==(const HelmExpectation&) const = default;
};
struct LapsExpectation {  ///< kind = "laps": a task's points were all passed.
  std::string vehicle;
  std::string task;
  int64_t at_least = 1;
  double by_s = 0;  ///< 0: by the end.

  bool operator==(const LapsExpectation&) const = default;
};
struct TrackExpectation {  ///< kind = "track": the cross-track error stays within a limit.
  std::string vehicle;
  double max_m = 1;
  double from_s = 0;  ///< From then on, while a task runs that has a track.

  bool operator==(const TrackExpectation&) const = default;
};
struct DistanceExpectation {  ///< kind = "distance": to another vehicle, in three dimensions.
  std::string vehicle;
  std::string to;
  std::optional<double> min_m = std::nullopt;
  std::optional<double> max_m = std::nullopt;
  double from_s = 0;

  bool operator==(const DistanceExpectation&) const = default;
};
struct AltitudeExpectation {  ///< kind = "altitude": above the sea floor, at least.
  std::string vehicle;
  double min_m = 0;

  bool operator==(const AltitudeExpectation&) const = default;
};
struct Expectation {
  std::string where;  ///< "file:line" of its table, for the verdict.
  std::variant<ArrivalExpectation, SeparationExpectation, CommsExpectation, HelmExpectation,
               LapsExpectation, TrackExpectation, DistanceExpectation, AltitudeExpectation,
               SwarmExpectation>
      what;

  bool operator==(const Expectation&) const = default;
};

/// What happens when a participant dies or hangs.
enum class OnLoss { kEnd, kContinue, kRestart };

struct Mission {
  std::string file;  ///< As given on the command line.
  std::string name;  ///< Default: the file's stem.
  std::string description;
  uint64_t seed = 1;
  double duration_s = 0;      ///< > 0; required.
  int64_t tick_us = 100'000;  ///< `tick_s`; one step of mission time.
  int64_t start_utime = 0;
  double origin_lat_deg = 43.825300;  ///< MOOS-IvP's example missions start here.
  double origin_lon_deg = -70.330400;
  OnLoss on_loss = OnLoss::kEnd;
  double participant_timeout_s = 5;    ///< Of wall time.
  Provider broker = Provider::kShoal;  ///< `shore_broker = ...`
  Environment environment;
  RoutingRules comms;
  Acoustics acoustics;
  std::vector<Vehicle> vehicles;
  SwarmOptions swarm;
  std::optional<NetsimOptions> netsim;  ///< Who takes part over netsim's interface.
  std::vector<Event> events;            ///< In order of time; equal times in file order.
  std::vector<Participant> participants;
  std::vector<Expectation> expectations;

  /// Returns the number of the last step: steps run from 0 to this.
  int64_t LastStep() const;
  /// Returns the mission time of a step.
  int64_t UtimeOf(int64_t step) const { return start_utime + step * tick_us; }
  /// Returns the vehicle of this name, without regard to case, or nullptr.
  const Vehicle* FindVehicle(std::string_view vehicle_name) const;
  /// True for the leader and the followers of the swarm.
  bool IsInSwarm(const Vehicle& vehicle) const;

  bool operator==(const Mission&) const = default;
};

}  // namespace shoal
