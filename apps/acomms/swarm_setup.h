// A mission's swarm as one of its members needs it: receiver and schedule.
#pragma once

#include "lib/comms/swarm/schedule.h"
#include "lib/comms/swarm/swarm_receiver.h"
#include "lib/mission/model/mission.h"

namespace shoal {

/// Returns the receiver of `vehicle`: it knows all members by their acoustic addresses, and that
/// they begin where the mission file has them start. @pre mission.SwarmOf(vehicle)
[[nodiscard]] SwarmReceiver MakeSwarmReceiver(const Mission& mission, const Vehicle& vehicle);

/// Returns when `vehicle` sends: the leader has place 0, the first follower 1.
/// @pre mission.SwarmOf(vehicle), and its slots have no problems
[[nodiscard]] SwarmSchedule MakeSwarmSchedule(const Mission& mission, const Vehicle& vehicle);

/// Returns a member's id in messages.
[[nodiscard]] uint32_t SwarmIdOf(const Vehicle& vehicle);

/// Returns the swarm of `vehicle`. @pre mission.SwarmOf(vehicle)
[[nodiscard]] const SwarmOptions& OwnSwarm(const Mission& mission, const Vehicle& vehicle);

/// Returns the leader and the followers of the swarm of `vehicle`, in the order of the mission
/// file. @pre mission.SwarmOf(vehicle)
[[nodiscard]] std::vector<const Vehicle*> SwarmMembers(const Mission& mission,
                                                       const Vehicle& vehicle);

}  // namespace shoal
