// Whether the members of [swarm], or of each [[swarm]], can receive each other's messages.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/broadcast_message.h"
#include "lib/comms/swarm/field_checks.h"
#include "lib/comms/swarm/message_frame.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/model/swarm_plan.h"

namespace shoal {
namespace {

void CheckFollowers(const TablePlace& place, const Mission& mission, const SwarmOptions& swarm) {
  if (mission.FindVehicle(swarm.leader) == nullptr) return;  // That is refused already.
  std::set<std::string_view> seen;
  for (const std::string& follower : swarm.followers) {
    if (follower == swarm.leader) {
      place.Refuse("followers", fmt::format("{} leads; it is not a follower", follower));
    } else if (!seen.insert(follower).second) {
      place.Refuse("followers", fmt::format("{} is named twice", follower));
    }
  }
  const int64_t most = swarm.limits.max_followers;
  if (static_cast<int64_t>(swarm.followers.size()) > most) {
    place.Refuse("followers", fmt::format("{} followers are more than max_followers = {} of "
                                          "[swarm.fields]: their requests would count as damaged",
                                          swarm.followers.size(), most));
  }
  if (swarm.followers.empty()) {
    place.Refuse("followers",
                 "the swarm has no followers: write followers = [\"bravo\"], or give a vehicle a "
                 "task of kind "
                 "= \"target_track\" and swarm = \"acoustic\"");
  }
}

/// Members know each other by their acoustic addresses, which muNet wants to lie near each other.
void CheckMemberAddresses(const TablePlace& place, const Mission& mission,
                          const SwarmOptions& swarm) {
  const Vehicle* low = nullptr;
  const Vehicle* high = nullptr;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (mission.SwarmOf(vehicle) != &swarm) continue;
    if (low == nullptr || vehicle.acoustic_address < low->acoustic_address) low = &vehicle;
    if (high == nullptr || vehicle.acoustic_address > high->acoustic_address) high = &vehicle;
  }
  const int64_t limit = swarm.limits.max_id_distance;
  if (low == nullptr || high->acoustic_address - low->acoustic_address <= limit) return;
  place.Refuse(
      "leader",
      fmt::format("the acoustic_address of {} is {} and that of {} {}: members farther "
                  "than {} apart take each other's messages for damaged",
                  low->name, low->acoustic_address, high->name, high->acoustic_address, limit));
}

/// What a member needs so that the others receive its messages.
void CheckMembers(const TablePlace& place, const Mission& mission, const SwarmOptions& swarm) {
  const double limit_m = swarm.limits.max_position_m;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (mission.SwarmOf(vehicle) != &swarm) continue;
    const bool leads = vehicle.name == swarm.leader;
    const std::string_view key = leads ? "leader" : "followers";
    if (std::max(std::abs(vehicle.start.x_m), std::abs(vehicle.start.y_m)) > limit_m) {
      place.Refuse(key, fmt::format("{} starts more than {:g} km from the origin, farther than the "
                                    "messages of a swarm can encode: move [mission] origin",
                                    vehicle.name, limit_m / 1000));
    }
    if (!leads && vehicle.acoustic_leader &&
        AcousticsOf(mission, swarm.over).options.access_mode == AccessMode::kTdmaLf) {
      place.Refuse(key,
                   fmt::format("{} has acoustic_leader = true: it would not receive {}; only the "
                               "leader of [swarm] may have it",
                               vehicle.name, swarm.leader));
    }
    if (!mission.IsReported(vehicle) && vehicle.sim == Provider::kNone) {
      place.Warn(
          key,
          fmt::format(
              "node_reporter and vehicle_sim of {} are \"none\": unless a program of yours sends "
              "its reports or NAV, the broker does not know where it is, and none of "
              "its messages is sent or received",
              vehicle.name));
    }
    if (vehicle.sim == Provider::kNone && vehicle.acomms == Provider::kShoal) {
      place.Warn(key, fmt::format("vehicle_sim of {} is \"none\": unless a program of yours "
                                  "publishes its NAV, it never sends",
                                  vehicle.name));
    }
  }
}

/// Slots that come too late to be of use.
void WarnOfLateSlots(const TablePlace& place, const Mission& mission, const SwarmOptions& swarm) {
  const SlotPlan plan = PlanSwarm(mission, swarm).plan;
  const double episode_s = Seconds(plan.episode_us);
  const double last_s = Seconds(plan.offset_us) * static_cast<double>(swarm.followers.size());
  if (plan.scheme != SwarmScheme::kTdmaLf && last_s > mission.duration_s) {
    place.Warn("offset_s", fmt::format("{} sends first after {:g} s, when the mission is over",
                                       swarm.followers.back(), last_s));
  }
  if (episode_s > mission.duration_s) {
    place.Warn("episode_s",
               fmt::format("an episode takes {:g} s, longer than the mission", episode_s));
  }
  if (swarm.silent_after_s < episode_s) {
    place.Warn(
        "silent_after_s",
        fmt::format("every member counts as silent {:g} s after a message, and the next comes "
                    "after {:g} s",
                    swarm.silent_after_s, episode_s));
  }
  if (mission.duration_s > swarm.limits.max_time_s) {
    place.Warn("leader",
               fmt::format("time stamps of messages end at {:g} s: from then on all count "
                           "as damaged",
                           swarm.limits.max_time_s));
  }
}

/// Members farther apart than comms_range receive nothing of each other, whatever the water does.
void WarnOfRange(const TablePlace& place, const Mission& mission, const SwarmOptions& swarm) {
  const double range_m = mission.comms.comms_range_m;
  if (range_m < 0 || swarm.max_distance_m <= range_m) return;
  place.Warn(
      "max_distance_m",
      fmt::format("members may be {:g} m apart, and comms_range lets packets through up to "
                  "{:g} m: write comms_range = \"nolimit\" in [comms], which leaves the range "
                  "to the acoustic network, or max_distance_m = {:g}",
                  swarm.max_distance_m, range_m, range_m));
}

/// A message must fit into a packet of the modem.
void CheckPackets(const TablePlace& place, const Mission& mission, const SwarmOptions& swarm) {
  const std::optional<ModemPreset>& modem = AcousticsOf(mission, swarm.over).options.modem;
  if (!modem || modem->max_packet_bytes <= 0) return;
  const bool asks = SwarmSchemeOf(mission, swarm) == SwarmScheme::kTdmaLf;
  const size_t longest = (asks ? BroadcastBytes(swarm.followers.size()) : kLeaderReportBytes) +
                         (swarm.frames ? kFrameBytes : 0);
  if (static_cast<int64_t>(longest) <= modem->max_packet_bytes) return;
  place.Refuse("leader", fmt::format("the leader's message takes {} bytes, and a packet of the {} "
                                     "holds {}: choose another modem{}",
                                     longest, modem->name, modem->max_packet_bytes,
                                     asks ? ", fewer followers, or scheduler = \"tdma\"" : ""));
}

void CheckSlots(const TablePlace& place, const Mission& mission, const SwarmOptions& swarm) {
  const bool needs_channels = swarm.scheduler == "fdma_lf";
  if (needs_channels && AcousticsOf(mission, swarm.over).options.access_mode != AccessMode::kFdma) {
    place.Refuse("scheduler",
                 "fdma_lf needs a channel for each vehicle: write access_mode = "
                 "\"fdma\" in [acoustics], or scheduler = \"tdma\"");
    return;
  }
  for (const TimingProblem& problem : PlanSwarm(mission, swarm).problems) {
    place.Refuse(problem.key, problem.message);
  }
}

}  // namespace

void ValidateSwarm(const Mission& mission, const TablePlace& file) {
  bool are_sound = true;
  for (size_t i = 0; i < mission.swarms.size(); ++i) {
    const SwarmOptions& swarm = mission.swarms[i];
    const TablePlace place = TableOfSwarm(mission, file, i);
    // If one of several swarms is wrong, its followers may be wrong too, and are not checked.
    if (swarm.name.empty() || place.IsSound()) CheckFollowers(place, mission, swarm);
    if (!AcousticsOf(mission, swarm.over).is_used) {
      place.Refuse("leader",
                   "a swarm sends over an acoustic network: write [acoustics] as well, or name a "
                   "[[medium]] of kind = \"acoustic\" in over");
    }
    are_sound = are_sound && place.IsSound();
    if (!place.IsSound()) continue;
    CheckMemberAddresses(place, mission, swarm);
    CheckMembers(place, mission, swarm);
    CheckPackets(place, mission, swarm);
    CheckSlots(place, mission, swarm);
    are_sound = are_sound && place.IsSound();
    if (!place.IsSound()) continue;
    WarnOfLateSlots(place, mission, swarm);
    WarnOfRange(place, mission, swarm);
  }
  if (are_sound && mission.swarms.size() > 1) ValidateSwarms(mission, file);
}

}  // namespace shoal
