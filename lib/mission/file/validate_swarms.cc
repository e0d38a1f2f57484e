// Whether several [[swarm]] can be in one mission: names, members, group_id, and slots on one
// network.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/mission/file/validate.h"
#include "lib/mission/model/swarm_plan.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

/// What one member sends, again and again, on one channel.
struct PeriodicSlot {
  std::string member;
  int64_t first_us = 0;
  int64_t length_us = 0;  ///< From its beginning until the last receiver has all of it.
  int64_t period_us = 0;
  int channel = 0;  ///< -1: one that it shares with no other.
};

std::vector<PeriodicSlot> SlotsOf(const Mission& mission, const SwarmOptions& swarm) {
  const SlotPlan plan = PlanSwarm(mission, swarm).plan;
  const Result<AirTimes> times = FindAirTimes(SwarmAirOf(mission, swarm));
  if (!times.ok()) return {};
  const AccessMode mode = AcousticsOf(mission, swarm.over).options.access_mode;
  const bool asks = plan.scheme == SwarmScheme::kTdmaLf;
  const int64_t way_us = times->travel_us + times->jitter_us;
  std::vector<PeriodicSlot> slots;
  const auto add = [&](const std::string& member, int64_t first_us, int64_t air_us) {
    const bool leads = member == swarm.leader;
    const int shared = mode == AccessMode::kTdmaLf && !leads ? 1 : 0;
    slots.push_back({.member = member,
                     .first_us = first_us,
                     .length_us = air_us + way_us,
                     .period_us = plan.episode_us,
                     .channel = mode == AccessMode::kFdma ? -1 : shared});
  };
  add(swarm.leader, 0, asks ? times->request_us : times->leader_report_us);
  for (size_t i = 0; i < swarm.followers.size(); ++i) {
    const auto place = static_cast<int64_t>(i);
    add(swarm.followers[i],
        asks ? plan.broadcast_us + place * plan.response_us : (place + 1) * plan.offset_us,
        times->report_us);
  }
  return slots;
}

/// Two slots with periods overlap at some time where their beginnings, modulo the greatest common
/// divisor of the periods, do.
bool Overlap(const PeriodicSlot& a, const PeriodicSlot& b) {
  if (a.channel < 0 || a.channel != b.channel) return false;
  const int64_t step_us = std::gcd(a.period_us, b.period_us);
  const int64_t later_us = ((b.first_us - a.first_us) % step_us + step_us) % step_us;
  return later_us < a.length_us || step_us - later_us < b.length_us;
}

std::optional<std::pair<PeriodicSlot, PeriodicSlot>> FindOverlap(const Mission& mission,
                                                                 const SwarmOptions& a,
                                                                 const SwarmOptions& b) {
  const std::vector<PeriodicSlot> others = SlotsOf(mission, b);
  for (const PeriodicSlot& slot : SlotsOf(mission, a)) {
    for (const PeriodicSlot& other : others) {
      if (Overlap(slot, other)) return std::pair(slot, other);
    }
  }
  return std::nullopt;
}

/// A vehicle has one leader, one group_id and one SWARM_V.
void CheckDistinctMembers(const Mission& mission, const TablePlace& file) {
  std::map<std::string, size_t> swarm_of;
  for (size_t i = 0; i < mission.swarms.size(); ++i) {
    const SwarmOptions& swarm = mission.swarms[i];
    std::vector<std::string> names = swarm.followers;
    names.insert(names.begin(), swarm.leader);
    for (const std::string& name : names) {
      const auto [at, is_new] = swarm_of.emplace(name, i);
      if (is_new || at->second == i) continue;
      TableOfSwarm(mission, file, i)
          .Refuse(name == swarm.leader ? "leader" : "followers",
                  fmt::format("{} is in the swarm {} already: a vehicle can be in one only", name,
                              Quoted(mission.swarms[at->second].name)));
    }
  }
}

void CheckPair(const Mission& mission, const TablePlace& place, const SwarmOptions& swarm,
               const SwarmOptions& earlier) {
  if (swarm.name == earlier.name) {
    place.Refuse("name", fmt::format("a swarm {} exists already: give this one another name",
                                     Quoted(swarm.name)));
  }
  const Acoustics& network = AcousticsOf(mission, swarm.over);
  if (&network != &AcousticsOf(mission, earlier.over)) return;
  if (swarm.group_id == earlier.group_id) {
    place.Refuse("group_id", fmt::format("the swarm {} has group_id = {} too, on the same network: "
                                         "leave both out, or give this one another",
                                         Quoted(earlier.name), Quoted(swarm.group_id)));
  }
  if (swarm.frames != earlier.frames) {
    place.Refuse("frames", fmt::format("the swarm {} on the same network has frames = {}: each "
                                       "would take the other's messages for damaged ones",
                                       Quoted(earlier.name), earlier.frames));
  }
  if (network.options.collisions == CollisionModel::kOff) return;
  if (const auto both = FindOverlap(mission, earlier, swarm)) {
    place.Warn("leader",
               fmt::format("slots of {} of the swarm {} and of {} of {} overlap on one channel, "
                           "which damages both messages: write access_mode = \"fdma\" in the "
                           "network's table, or let over name another [[medium]]",
                           both->first.member, Quoted(earlier.name), both->second.member,
                           Quoted(swarm.name)));
  }
}

}  // namespace

void ValidateSwarms(const Mission& mission, const TablePlace& file) {
  CheckDistinctMembers(mission, file);
  for (size_t i = 1; i < mission.swarms.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      CheckPair(mission, TableOfSwarm(mission, file, i), mission.swarms[i], mission.swarms[k]);
    }
  }
}

}  // namespace shoal
