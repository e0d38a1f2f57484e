#include "apps/acomms/swarm_setup.h"

#include <algorithm>
#include <cmath>

#include "lib/check/check.h"
#include "lib/geometry/angles.h"
#include "lib/mission/swarm_plan.h"

namespace shoal {

namespace {

Motion StartOf(const Vehicle& vehicle) {
  const Eigen::Vector2d velocity_mps =
      vehicle.start.speed_mps * UnitVector(DegToRad(vehicle.start.heading_deg));
  return {.position_m = {vehicle.start.x_m, vehicle.start.y_m, vehicle.start.depth_m},
          .velocity_mps = {velocity_mps.x(), velocity_mps.y(), 0}};
}

}  // namespace

uint32_t SwarmIdOf(const Vehicle& vehicle) {
  return static_cast<uint32_t>(vehicle.acoustic_address);
}

std::vector<const Vehicle*> SwarmMembers(const Mission& mission) {
  std::vector<const Vehicle*> members;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (mission.IsInSwarm(vehicle)) members.push_back(&vehicle);
  }
  return members;
}

SwarmReceiver MakeSwarmReceiver(const Mission& mission, const Vehicle& vehicle) {
  const auto group_id = static_cast<uint8_t>(mission.swarm.group_id.front());
  SwarmReceiver receiver;
  receiver.state.own_id = SwarmIdOf(vehicle);
  receiver.state.group_id = group_id;
  receiver.state.is_leader = vehicle.name == mission.swarm.leader;
  receiver.state.episode_us = PlanSwarm(mission).plan.episode_us;
  receiver.plan = vehicle.recovery;
  receiver.state.sentinel = mission.swarm.sentinel;
  receiver.state.neutral = mission.swarm.neutral;
  receiver.limits = mission.swarm.limits;
  // A request may arrive in the very step in which the first answer is to begin, and float32 rounds
  // that time.
  receiver.limits.late_start_us = mission.swarm.late_start_s < 0
                                      ? mission.tick_us
                                      : std::llround(mission.swarm.late_start_s * 1e6);
  receiver.has_frames = mission.swarm.frames;
  // Followers in the order of their slots, which is that of the leader's requests.
  for (const std::string& name : mission.swarm.followers) {
    const Vehicle* follower = mission.FindVehicle(name);
    SHOAL_CHECK(follower != nullptr, "the mission file was checked");
    if (follower->name == vehicle.name) continue;
    receiver.state.members.push_back(
        PlacedContact(SwarmIdOf(*follower), group_id, StartOf(*follower)));
  }
  if (!receiver.state.is_leader) {
    const Vehicle* leader = mission.FindVehicle(mission.swarm.leader);
    SHOAL_CHECK(leader != nullptr, "the mission file was checked");
    receiver.state.target = PlacedContact(SwarmIdOf(*leader), group_id, StartOf(*leader));
    receiver.state.target->sentinel = mission.swarm.sentinel;
  }
  for (SwarmContact& member : receiver.state.members) member.sentinel = mission.swarm.sentinel;
  return receiver;
}

SwarmSchedule MakeSwarmSchedule(const Mission& mission, const Vehicle& vehicle) {
  const SwarmSlots slots = PlanSwarm(mission);
  SHOAL_CHECK(slots.problems.empty(), "the mission file was checked");
  const std::vector<std::string>& followers = mission.swarm.followers;
  const bool is_leader = vehicle.name == mission.swarm.leader;
  const auto found = std::find(followers.begin(), followers.end(), vehicle.name);
  SHOAL_CHECK(is_leader || found != followers.end(), "only members have slots");
  return SwarmSchedule(
      slots.plan, {.is_leader = is_leader, .place = is_leader ? 0 : found - followers.begin() + 1});
}

}  // namespace shoal
