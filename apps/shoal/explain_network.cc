#include "apps/shoal/explain_network.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <string_view>
#include <vector>

#include "lib/base/time/seconds.h"
#include "lib/mission/model/swarm_plan.h"
#include "lib/sea/acoustics/channel_plan.h"

namespace shoal {

namespace {

using NameList = std::vector<std::string>;

constexpr size_t kMaxNames = 8;
constexpr size_t kMaxChannelsShown = 60;

std::string NamesText(NameList names, size_t num_all) {
  if (names.size() == num_all) return "all";
  if (names.empty()) return "none";
  const size_t num_more = names.size() > kMaxNames ? names.size() - kMaxNames : 0;
  names.resize(names.size() - num_more);
  std::string text = fmt::format("{}", fmt::join(names, ", "));
  return num_more == 0 ? text : text + fmt::format(" and {} more", num_more);
}

/// `medium`: of [[medium]]; that of [acoustics] is not named.
std::string ChannelsText(const Mission& mission, const AcousticOptions& options,
                         std::string_view medium) {
  std::vector<AcousticNode> nodes;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (!vehicle.HasMedium(medium)) continue;
    nodes.push_back({.name = vehicle.name,
                     .address = vehicle.acoustic_address,
                     .is_leader = vehicle.acoustic_leader});
  }
  const Result<ChannelPlan> plan = ChannelPlan::Make(options, nodes);
  if (!plan.ok()) return "";  // The mission has been refused for it.
  std::string text = fmt::format(
      "\n# Acoustic channels{}, access_mode {}: {} of at most {} in {:g} kHz around {:g} kHz, "
      "{:g} bit/s each\n#     {:>10} {:>9} {:>6}  sends / receives\n",
      medium == kAcousticMedium ? "" : fmt::format(" of the medium {}", medium),
      ChoiceText(options.access_mode), plan->channels().size(),
      options.access_mode == AccessMode::kFdma ? ChannelCapacity(options)
                                               : static_cast<int>(plan->channels().size()),
      options.bandwidth_khz, options.base_freq_khz, options.data_rate_bps, "id", "kHz", "width");
  for (size_t i = 0; i < plan->channels().size() && i < kMaxChannelsShown; ++i) {
    const auto channel = static_cast<int>(i);
    NameList senders;
    NameList receivers;
    for (int node = 0; node < plan->num_nodes(); ++node) {
      const std::string& name = nodes[static_cast<size_t>(node)].name;
      if (plan->SendsOn(node) == channel) senders.push_back(name);
      if (plan->ReceivesOn(node, channel)) receivers.push_back(name);
    }
    const AcousticChannel& each = plan->channel(channel);
    // A sender never receives itself, which NamesText does not count as missing.
    const size_t num_others = nodes.size() - (senders.size() == 1 ? 1 : 0);
    text += fmt::format("#     {:>10} {:>9.3f} {:>6.2f}  {} / {}{}\n", each.id, each.freq_khz,
                        each.bandwidth_khz, NamesText(senders, nodes.size()),
                        senders.size() == 1 && receivers.size() == num_others
                            ? std::string("all others")
                            : NamesText(receivers, nodes.size()),
                        each.is_broadcast ? " (broadcast)" : "");
  }
  if (plan->channels().size() > kMaxChannelsShown) {
    text += fmt::format("#     (and {} more)\n", plan->channels().size() - kMaxChannelsShown);
  }
  return text;
}

std::string SlotsText(const Mission& mission, const SwarmOptions& swarm) {
  const SlotPlan plan = PlanSwarm(mission, swarm).plan;
  const Result<AirTimes> times = FindAirTimes(SwarmAirOf(mission, swarm));
  if (!times.ok()) return "";  // The mission has been refused for it.
  std::string text = fmt::format(
      "\n# Slots of the swarm{}, {}: episode {:g} s",
      swarm.name.empty() ? "" : fmt::format(" {} (group_id {})", swarm.name, swarm.group_id),
      plan.scheme == SwarmScheme::kTdmaLf   ? "tdma_lf"
      : plan.scheme == SwarmScheme::kFdmaLf ? "fdma_lf"
                                            : "tdma",
      Seconds(plan.episode_us));
  if (plan.scheme == SwarmScheme::kTdmaLf) {
    text += fmt::format(", request {:g} s, answers {:g} s each\n", Seconds(plan.broadcast_us),
                        Seconds(plan.response_us));
  } else {
    text += fmt::format(", from member to member {:g} s\n", Seconds(plan.offset_us));
  }
  text += fmt::format(
      "#     on the air: report {:g} s, leader's report {:g} s, request {:g} s; travel over {:g} m "
      "{:g} s, jitter {:g} s\n#     {:<16} {:>8}  first slot\n",
      Seconds(times->report_us), Seconds(times->leader_report_us), Seconds(times->request_us),
      swarm.max_distance_m, Seconds(times->travel_us), Seconds(times->jitter_us), "member", "id");
  NameList members = {swarm.leader};
  members.insert(members.end(), swarm.followers.begin(), swarm.followers.end());
  for (size_t i = 0; i < members.size(); ++i) {
    const auto place = static_cast<int64_t>(i);
    const bool is_asked = plan.scheme == SwarmScheme::kTdmaLf && i > 0;
    const int64_t first_us =
        is_asked ? plan.broadcast_us + (place - 1) * plan.response_us : place * plan.offset_us;
    const Vehicle* vehicle = mission.FindVehicle(members[i]);
    text += fmt::format("#     {:<16} {:>8}  {:g} s{}\n", members[i],
                        vehicle == nullptr ? 0 : vehicle->acoustic_address, Seconds(first_us),
                        is_asked ? ", when asked" : "");
  }
  return text;
}

std::string StrategiesText(const RecoveryOrder& order) {
  NameList names;
  for (const RecoveryStrategy strategy : order) names.emplace_back(NameOf(strategy));
  return names.empty() ? "(dropped)" : fmt::format("{}", fmt::join(names, ", "));
}

/// The strategies of members that have none of their own; the others' are in their tables.
std::string RecoveryText(const Mission& mission) {
  NameList names;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (mission.SwarmOf(vehicle) != nullptr && vehicle.recovery == RecoveryPlan()) {
      names.push_back(vehicle.name);
    }
  }
  if (names.empty()) return "";
  std::string text = fmt::format("\n# Recovery of damaged fields by {}: the default\n",
                                 NamesText(names, mission.vehicles.size()));
  std::map<std::string, NameList> fields_by_text;
  const RecoveryPlan plan;
  for (size_t i = 0; i < kNumSwarmFields; ++i) {
    fields_by_text[StrategiesText(plan.by_field[i])].emplace_back(kSwarmFieldNames.At(i));
  }
  for (const auto& [strategies, fields] : fields_by_text) {
    text += fmt::format("#     {:<28} {}\n", strategies, fmt::join(fields, ", "));
  }
  return text;
}

}  // namespace

std::string ExplainNetwork(const Mission& mission) {
  std::string text;
  if (mission.acoustics.is_used) {
    text += ChannelsText(mission, mission.acoustics.options, kAcousticMedium);
  }
  for (const MediumOptions& medium : mission.media) {
    if (medium.kind != MediumKind::kAcoustic) continue;
    text += ChannelsText(mission, medium.acoustics.options, medium.name);
  }
  for (const SwarmOptions& swarm : mission.swarms) text += SlotsText(mission, swarm);
  if (!mission.swarms.empty()) text += RecoveryText(mission);
  return text;
}

}  // namespace shoal
