// When the members of a mission's swarm send: its [swarm] made into slots, with automatic lengths
// filled in.
//
//   const SwarmSlots slots = PlanSwarm(mission, mission.swarms[0]);
//   for (const TimingProblem& problem : slots.problems) Report(problem.message);
//   SwarmSchedule schedule(slots.plan, {.is_leader = true});
#pragma once

#include <vector>

#include "lib/comms/swarm/schedule.h"
#include "lib/comms/swarm/slot_timing.h"
#include "lib/mission/model/mission.h"

namespace shoal {

/// Returns the acoustic network that packets sent `over` this go by: the first that it names,
/// [acoustics] or a [[medium]] of kind = "acoustic"; where it names none, [acoustics], used or not.
[[nodiscard]] const Acoustics& AcousticsOf(const Mission& mission, const MediaChoice& over);

/// Returns what carries the packets on ACOUSTIC_TX of vehicles without a swarm, and of modems: as
/// those of the first swarm.
[[nodiscard]] const MediaChoice& PacketsOver(const Mission& mission);
/// Returns their acoustic network.
[[nodiscard]] const Acoustics& PacketAcousticsOf(const Mission& mission);

/// Returns the properties of the acoustic network that a swarm's messages are sent over.
[[nodiscard]] SwarmAir SwarmAirOf(const Mission& mission, const SwarmOptions& swarm);

/// Returns the scheduler that the swarm names, or the one that its network's access mode suggests.
[[nodiscard]] SwarmScheme SwarmSchemeOf(const Mission& mission, const SwarmOptions& swarm);

struct SwarmSlots {
  SlotPlan plan;
  std::vector<TimingProblem> problems;  ///< With a key of [swarm] or of [acoustics].
};

/// Returns the slots. "auto" is, for fdma_lf, muNet's episode of 5 s and 0.5 s from member to
/// member, longer where the messages do not fit; else the shortest without overlap.
[[nodiscard]] SwarmSlots PlanSwarm(const Mission& mission, const SwarmOptions& swarm);

}  // namespace shoal
