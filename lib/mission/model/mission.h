// A mission as data, every default filled in. lib/mission/file/load.h makes one from a file;
// docs/missions/mission_file.md documents each key.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/routing/rules.h"
#include "lib/comms/swarm/field_checks.h"
#include "lib/comms/swarm/group_state.h"
#include "lib/helm/behaviors/behavior.h"
#include "lib/mission/model/environment.h"
#include "lib/mission/model/event.h"
#include "lib/mission/model/expectation.h"
#include "lib/mission/model/media_options.h"
#include "lib/mission/model/navigation_options.h"
#include "lib/mission/model/vehicle.h"
#include "lib/mission/netsim/netsim_options.h"

namespace shoal {

/// `[swarm]`, or one of several `[[swarm]]`: how a leader and its followers exchange their
/// positions over an acoustic network. Lengths of time below 0 are "auto":
/// lib/mission/model/swarm_plan.h finds them.
struct SwarmOptions {
  std::string name = {};                    ///< Of a [[swarm]]; [swarm] has none.
  std::string leader = {};                  ///< A vehicle.
  std::vector<std::string> followers = {};  ///< In the order of their slots, without the leader.
  std::vector<std::string> members =
      {};                          ///< Until loading ends: [[swarm]] members, then followers.
  std::string group = {};          ///< Until loading ends: likewise, of vehicles' groups.
  std::string scheduler = "auto";  ///< fdma_lf, tdma, tdma_lf; auto: by the access mode.
  double episode_s = -1;
  double offset_s = -1;          ///< fdma_lf, tdma: from one member's slot to the next.
  double broadcast_s = -1;       ///< tdma_lf: from the request to the first answer.
  double response_s = -1;        ///< tdma_lf: from one answer to the next.
  double max_distance_m = 1000;  ///< No two members are ever farther apart.
  bool frames = false;           ///< A sequence number and a checksum with each message.
  std::string group_id = "A";    ///< One letter or digit, sent with each message.
  double silent_after_s = 60;    ///< After this long without a message a member is silent.
  /// What carries its packets, and those on ACOUSTIC_TX of vehicles without a swarm (of several,
  /// those of the first count).
  MediaChoice over = {.names = {std::string(kAcousticMedium)}};
  FieldLimits limits = {};   ///< Its late_start_us counts only where late_start_s is 0 or more.
  double late_start_s = -1;  ///< FieldLimits::late_start_us; below 0: a step.
  NeutralValues neutral = {};
  SentinelValues sentinel = {};

  bool operator==(const SwarmOptions&) const = default;
};

/// `[[participant]]`: a user's own process that takes part in stepping.
struct Participant {
  std::string name;
  std::vector<std::string> command;  ///< Started by the launcher; empty: by the user.

  bool operator==(const Participant&) const = default;
};

/// What happens when a participant dies or hangs.
enum class OnLoss { kEnd, kContinue, kRestart };

/// `[[host]]`: another computer, on which `shoal host` runs the processes of some vehicles
/// (docs/missions/many_machines.md).
struct HostOptions {
  std::string name;
  std::string address;  ///< "tcp://10.0.0.2:7700"; empty until `shoal run` needs it.
  std::string key;      ///< Its public key: 40 characters of Z85, or the path of a file with it.
  std::vector<std::string> vehicles = {};
  std::vector<std::string> participants = {};  ///< Of [[participant]].
  OnLoss on_loss = OnLoss::kEnd;               ///< What becomes of the mission without the host.
  double timeout_s = 0.9;  ///< Of wall time; silence of the host for longer is its loss.

  bool operator==(const HostOptions&) const = default;
};

/// What two vehicles that touch make of the mission's verdict.
enum class CollisionVerdict { kFail, kAllowed };
/// `grounding = "fail" | "allowed"`
enum class GroundingVerdict { kFail, kAllowed };

struct Mission {
  // Defined once, in mission.cc: each takes a second to compile.
  Mission();
  ~Mission();
  Mission(const Mission&);
  Mission(Mission&&) noexcept;
  Mission& operator=(const Mission&);
  Mission& operator=(Mission&&) noexcept;

  std::string file;  ///< As given on the command line.
  std::string name;  ///< Default: the file's stem.
  std::string description;
  uint64_t seed = 1;
  bool draws_seed = false;    ///< `seed = "random"`: whoever starts the mission draws one.
  double duration_s = 0;      ///< > 0; required.
  int64_t tick_us = 100'000;  ///< `tick_s`; one step of mission time.
  int64_t start_utime = 0;
  double origin_lat_deg = 43.825300;  ///< MOOS-IvP's example missions start here.
  double origin_lon_deg = -70.330400;
  std::vector<Eigen::Vector2d> op_area_m;  ///< Corners of the area of operations, for viewers.
  /// Files that viewers draw under the mission, relative to its file's folder.
  std::vector<std::string> backgrounds = {};
  OnLoss on_loss = OnLoss::kEnd;
  CollisionVerdict collisions = CollisionVerdict::kFail;
  GroundingVerdict grounding = GroundingVerdict::kFail;
  double participant_timeout_s = 5;    ///< Of wall time.
  Provider broker = Provider::kShoal;  ///< `shore_broker = ...`
  Environment environment;
  RoutingRules comms;
  Acoustics acoustics;
  std::vector<MediumOptions> media;    ///< Besides direct and acoustic.
  std::vector<Obstacle> obstacles;     ///< That do not move.
  std::vector<BeaconOptions> beacons;  ///< That vehicles with [vehicle.navigation] range to.
  std::vector<Vehicle> vehicles;
  std::vector<SwarmOptions> swarms;     ///< [swarm], or each [[swarm]].
  std::optional<NetsimOptions> netsim;  ///< Participants over netsim's interface.
  std::vector<Event> events;            ///< In order of time; equal times in file order.
  std::vector<NamedOrder> orders;       ///< Given by `shoal send NAME`.
  std::vector<Participant> participants;
  std::vector<HostOptions> hosts;  ///< None: all processes run on this computer.
  std::vector<Expectation> expectations;

  /// Returns the number of the last step: steps run from 0 to this.
  int64_t LastStep() const;
  /// Returns the mission time of a step.
  int64_t UtimeOf(int64_t step) const { return start_utime + step * tick_us; }
  /// Returns the vehicle of this name, without regard to case, or nullptr.
  const Vehicle* FindVehicle(std::string_view vehicle_name) const;
  /// Returns the vehicle of this name, all of them for "all", or for "group:NAME" the members of a
  /// group; names are the same without regard to case.
  std::vector<const Vehicle*> VehiclesNamed(std::string_view addressees) const;
  /// True for vehicles that others can receive reports of: with a node_reporter, or from outside
  /// over netsim.
  bool IsReported(const Vehicle& vehicle) const;
  /// True where programs of the user or clients of netsim may deploy vehicles, and move them.
  bool MayBeSteeredFromOutside() const;
  /// True where it has media of its own or a gateway: then each vehicle has its media, and the
  /// broker decides by where they are.
  bool HasMedia() const;
  /// Returns the swarm of which the vehicle is the leader or a follower, or nullptr.
  const SwarmOptions* SwarmOf(const Vehicle& vehicle) const;

  bool operator==(const Mission&) const;
};

/// Returns the members of each group, in the mission's order, by the group's name as its first
/// member has it. Groups are the same without regard to case.
[[nodiscard]] std::map<std::string, std::vector<std::string>> GroupsOf(const Mission& mission);

/// An [[order]] as `shoal send` takes commands: "patrol" means all, set, PATROL=true.
struct OrderWords {
  std::string name;
  std::string target;
  std::vector<std::string> words;

  bool operator==(const OrderWords&) const = default;
};

/// Returns the mission's orders, in the order of the file.
[[nodiscard]] std::vector<OrderWords> OrdersOf(const Mission& mission);

}  // namespace shoal
