// The table [swarm], and [vehicle.recovery].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/describe.h"
#include "lib/mission/suggest.h"
#include "lib/mission/swarm_plan.h"
#include "lib/swarm/broadcast_message.h"
#include "lib/swarm/field_checks.h"
#include "lib/swarm/message_frame.h"

namespace shoal {
namespace {

constexpr double kLongestEpisode_s = 1e5;
constexpr size_t kMostStrategies = kNumRecoveryStrategies;

/// Returns the vehicles that follow the leader by what the acoustic network lets through.
std::vector<std::string> AcousticFollowers(const Mission& mission) {
  std::vector<std::string> followers;
  for (const Vehicle& vehicle : mission.vehicles) {
    const bool follows =
        std::any_of(vehicle.tasks.begin(), vehicle.tasks.end(), [&](const Task& task) {
          const auto* track = std::get_if<TargetTrackTask>(&task.what);
          if (track == nullptr || track->swarm != SwarmKnowledge::kAcoustic) return false;
          return mission.FindVehicle(track->target) == mission.FindVehicle(mission.swarm.leader);
        });
    if (follows && vehicle.name != mission.swarm.leader) followers.push_back(vehicle.name);
  }
  return followers;
}

void DescribeFollowers(Fields& fields, Mission& mission) {
  SwarmOptions& swarm = mission.swarm;
  const bool is_named = fields.Has("followers", true);
  if (is_named) fields.Texts("followers", swarm.followers, static_cast<size_t>(kMostFollowers));
  if (!fields.reading()) return;
  if (mission.FindVehicle(swarm.leader) == nullptr) return;  // That was told already.
  if (!is_named) swarm.followers = AcousticFollowers(mission);
  std::set<std::string> seen;
  for (std::string& follower : swarm.followers) {
    ResolveVehicle(fields, "followers", follower, mission, false);
    if (follower == swarm.leader) {
      fields.Refuse("followers", fmt::format("{} leads; it is no follower", follower));
    } else if (!seen.insert(follower).second) {
      fields.Refuse("followers", fmt::format("{} is named twice", follower));
    }
  }
  if (swarm.followers.empty()) {
    fields.Refuse("followers",
                  "nobody follows: write followers = [\"bravo\"], or give a vehicle a task of kind "
                  "= \"target_track\" and swarm = \"acoustic\"");
  }
}

/// Members know each other by their acoustic addresses, which muNet wants to lie near each other.
void CheckAddresses(Fields& fields, const Mission& mission) {
  const Vehicle* low = nullptr;
  const Vehicle* high = nullptr;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (!mission.IsInSwarm(vehicle)) continue;
    if (low == nullptr || vehicle.acoustic_address < low->acoustic_address) low = &vehicle;
    if (high == nullptr || vehicle.acoustic_address > high->acoustic_address) high = &vehicle;
  }
  const int64_t limit = FieldLimits().max_id_distance;
  if (low == nullptr || high->acoustic_address - low->acoustic_address <= limit) return;
  fields.Refuse(
      "leader",
      fmt::format("the acoustic_address of {} is {} and that of {} {}: members farther "
                  "than {} apart take each other's messages for damaged",
                  low->name, low->acoustic_address, high->name, high->acoustic_address, limit));
}

/// What a member has to be so that the others hear of it.
void CheckMembers(Fields& fields, const Mission& mission) {
  const double limit_m = FieldLimits().max_position_m;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (!mission.IsInSwarm(vehicle)) continue;
    const bool leads = vehicle.name == mission.swarm.leader;
    const std::string_view key = leads ? "leader" : "followers";
    if (std::max(std::abs(vehicle.start.x_m), std::abs(vehicle.start.y_m)) > limit_m) {
      fields.Refuse(key,
                    fmt::format("{} starts more than {:g} km from the origin, farther than the "
                                "messages of a swarm can tell: move [mission] origin",
                                vehicle.name, limit_m / 1000));
    }
    if (!leads && vehicle.acoustic_leader &&
        mission.acoustics.options.access_mode == AccessMode::kTdmaLf) {
      fields.Refuse(key,
                    fmt::format("{} has acoustic_leader = true: it would not hear {}; only the "
                                "leader of [swarm] may have it",
                                vehicle.name, mission.swarm.leader));
    }
    if (vehicle.sim == Provider::kNone && vehicle.acomms == Provider::kShoal) {
      fields.Warn(key, fmt::format("vehicle_sim of {} is \"none\": unless a program of yours says "
                                   "its NAV, it never speaks",
                                   vehicle.name));
    }
  }
}

/// Slots that come too late to be of use.
void WarnOfLateSlots(Fields& fields, const Mission& mission) {
  const SlotPlan plan = PlanSwarm(mission).plan;
  const double episode_s = static_cast<double>(plan.episode_us) / 1e6;
  const double last_s = static_cast<double>(plan.offset_us) / 1e6 *
                        static_cast<double>(mission.swarm.followers.size());
  if (plan.scheme != SwarmScheme::kTdmaLf && last_s > mission.duration_s) {
    fields.Warn("offset_s", fmt::format("{} speaks first after {:g} s, when the mission is over",
                                        mission.swarm.followers.back(), last_s));
  }
  if (episode_s > mission.duration_s) {
    fields.Warn("episode_s",
                fmt::format("an episode takes {:g} s, longer than the mission", episode_s));
  }
  if (mission.swarm.silent_after_s < episode_s) {
    fields.Warn("silent_after_s",
                fmt::format("everybody counts as silent {:g} s after a message, and the next comes "
                            "after {:g} s",
                            mission.swarm.silent_after_s, episode_s));
  }
  if (mission.duration_s > FieldLimits().max_time_s) {
    fields.Warn("leader",
                fmt::format("time stamps of messages end at {:g} s: from then on all count "
                            "as damaged",
                            FieldLimits().max_time_s));
  }
}

/// A message must fit into a packet of the modem.
void CheckPackets(Fields& fields, const Mission& mission) {
  const std::optional<ModemPreset>& modem = mission.acoustics.options.modem;
  if (!modem || modem->max_packet_bytes <= 0) return;
  const bool asks = SwarmSchemeOf(mission) == SwarmScheme::kTdmaLf;
  const size_t longest =
      (asks ? BroadcastBytes(mission.swarm.followers.size()) : kLeaderReportBytes) +
      (mission.swarm.frames ? kFrameBytes : 0);
  if (static_cast<int64_t>(longest) <= modem->max_packet_bytes) return;
  fields.Refuse("leader", fmt::format("the leader's message takes {} bytes, and a packet of the {} "
                                      "holds {}: choose another modem{}",
                                      longest, modem->name, modem->max_packet_bytes,
                                      asks ? ", fewer followers, or scheduler = \"tdma\"" : ""));
}

void CheckSlots(Fields& fields, const Mission& mission) {
  const bool needs_channels = mission.swarm.scheduler == "fdma_lf";
  if (needs_channels && mission.acoustics.options.access_mode != AccessMode::kFdma) {
    fields.Refuse("scheduler",
                  "fdma_lf needs a channel for each vehicle: write access_mode = "
                  "\"fdma\" in [acoustics], or scheduler = \"tdma\"");
    return;
  }
  for (const TimingProblem& problem : PlanSwarm(mission).problems) {
    fields.Refuse(problem.key, problem.message);
  }
}

void DescribeSwarmTable(Fields& fields, Mission& mission) {
  constexpr std::array<std::string_view, 4> kSchedulers = {"auto", "fdma_lf", "tdma", "tdma_lf"};
  SwarmOptions& swarm = mission.swarm;
  swarm.exists = true;
  fields.Require("leader", "leader = \"alpha\"");
  fields.Text("leader", swarm.leader, {.min_length = 1});
  ResolveVehicle(fields, "leader", swarm.leader, mission, false);
  DescribeFollowers(fields, mission);
  fields.Word("scheduler", swarm.scheduler, kSchedulers);
  fields.NumberOrWord("episode_s", swarm.episode_s, kLongestEpisode_s, "auto", -1);
  fields.NumberOrWord("offset_s", swarm.offset_s, kLongestEpisode_s, "auto", -1);
  fields.NumberOrWord("broadcast_s", swarm.broadcast_s, kLongestEpisode_s, "auto", -1);
  fields.NumberOrWord("response_s", swarm.response_s, kLongestEpisode_s, "auto", -1);
  fields.Number("max_distance_m", swarm.max_distance_m, Above(0, 1e6));
  fields.Flag("frames", swarm.frames);
  fields.Text("group_id", swarm.group_id, {.min_length = 1, .max_length = 1});
  fields.Number("silent_after_s", swarm.silent_after_s, Above(0, kLongest_s));
  if (!fields.reading()) return;
  if (!swarm.group_id.empty() && !std::isalnum(static_cast<unsigned char>(swarm.group_id[0]))) {
    fields.Refuse("group_id", "group_id must be a letter or a digit");
  }
  if (!mission.acoustics.is_used) {
    fields.Refuse("leader", "a swarm talks through the water: write [acoustics] as well");
  }
  if (!fields.IsSound()) return;
  CheckAddresses(fields, mission);
  CheckMembers(fields, mission);
  CheckPackets(fields, mission);
  CheckSlots(fields, mission);
  if (fields.IsSound()) WarnOfLateSlots(fields, mission);
}

}  // namespace

void DescribeSwarm(Fields& file, Mission& mission) {
  if (!file.Has("swarm", mission.swarm.exists)) return;
  file.Below("swarm", [&](Fields& fields) { DescribeSwarmTable(fields, mission); });
}

void MarkSwarmLeader(Fields& file, Mission& mission) {
  file.Skip("swarm");
  if (!file.Has("swarm", false)) return;
  std::string leader;
  file.Below("swarm", [&](Fields& fields) {
    fields.SkipRest();
    if (fields.HoldsText("leader")) fields.Text("leader", leader, {});
  });
  const Vehicle* found = mission.FindVehicle(leader);
  for (Vehicle& vehicle : mission.vehicles) {
    if (&vehicle == found) vehicle.acoustic_leader = true;
  }
}

void Describe(Fields& fields, RecoveryPlan& plan) {
  for (size_t i = 0; i < kNumSwarmFields; ++i) {
    const std::string_view key = kSwarmFieldNames[i];
    std::vector<std::string> words;
    for (const RecoveryStrategy strategy : plan.by_field[i]) words.emplace_back(NameOf(strategy));
    fields.Texts(key, words, kMostStrategies);
    RecoveryOrder order;
    for (const std::string& word : words) {
      if (const auto strategy = RecoveryStrategyOf(word)) {
        order.push_back(*strategy);
      } else {
        fields.Refuse(key, "unknown strategy " + Quoted(word) +
                               DidYouMean(word, kRecoveryStrategyNames) +
                               "; there are: " + Joined(kRecoveryStrategyNames));
      }
    }
    plan.by_field[i] = order;
  }
}

}  // namespace shoal
