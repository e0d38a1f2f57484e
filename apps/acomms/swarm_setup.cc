#include "apps/acomms/swarm_setup.h"

#include <algorithm>
#include <cmath>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/mission/model/swarm_plan.h"

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

const SwarmOptions& OwnSwarm(const Mission& mission, const Vehicle& vehicle) {
  const SwarmOptions* swarm = mission.SwarmOf(vehicle);
  SHOAL_CHECK(swarm != nullptr, "the vehicle is in a swarm");
  return *swarm;
}

std::vector<const Vehicle*> SwarmMembers(const Mission& mission, const Vehicle& vehicle) {
  const SwarmOptions* swarm = &OwnSwarm(mission, vehicle);
  std::vector<const Vehicle*> members;
  for (const Vehicle& each : mission.vehicles) {
    if (mission.SwarmOf(each) == swarm) members.push_back(&each);
  }
  return members;
}

SwarmReceiver MakeSwarmReceiver(const Mission& mission, const Vehicle& vehicle) {
  const SwarmOptions& swarm = OwnSwarm(mission, vehicle);
  const auto group_id = static_cast<uint8_t>(swarm.group_id.front());
  SwarmReceiver receiver;
  receiver.state.own_id = SwarmIdOf(vehicle);
  receiver.state.group_id = group_id;
  receiver.state.is_leader = vehicle.name == swarm.leader;
  receiver.state.episode_us = PlanSwarm(mission, swarm).plan.episode_us;
  receiver.plan = vehicle.recovery;
  receiver.state.sentinel = swarm.sentinel;
  receiver.state.neutral = swarm.neutral;
  receiver.limits = swarm.limits;
  // A request may arrive in the very step in which the first answer is to begin, and float32 rounds
  // that time.
  receiver.limits.late_start_us =
      swarm.late_start_s < 0 ? mission.tick_us : Microseconds(swarm.late_start_s);
  receiver.has_frames = swarm.frames;
  // Followers in the order of their slots, which is that of the leader's requests.
  for (const std::string& name : swarm.followers) {
    const Vehicle* follower = mission.FindVehicle(name);
    SHOAL_CHECK(follower != nullptr, "the mission file was checked");
    if (follower->name == vehicle.name) continue;
    receiver.state.members.push_back(
        PlacedContact(SwarmIdOf(*follower), group_id, StartOf(*follower)));
  }
  if (!receiver.state.is_leader) {
    const Vehicle* leader = mission.FindVehicle(swarm.leader);
    SHOAL_CHECK(leader != nullptr, "the mission file was checked");
    receiver.state.target = PlacedContact(SwarmIdOf(*leader), group_id, StartOf(*leader));
    receiver.state.target->sentinel = swarm.sentinel;
  }
  for (SwarmContact& member : receiver.state.members) member.sentinel = swarm.sentinel;
  return receiver;
}

SwarmSchedule MakeSwarmSchedule(const Mission& mission, const Vehicle& vehicle) {
  const SwarmOptions& swarm = OwnSwarm(mission, vehicle);
  const SwarmSlots slots = PlanSwarm(mission, swarm);
  SHOAL_CHECK(slots.problems.empty(), "the mission file was checked");
  const std::vector<std::string>& followers = swarm.followers;
  const bool is_leader = vehicle.name == swarm.leader;
  const auto found = std::find(followers.begin(), followers.end(), vehicle.name);
  SHOAL_CHECK(is_leader || found != followers.end(), "only members have slots");
  return SwarmSchedule(
      slots.plan, {.is_leader = is_leader, .place = is_leader ? 0 : found - followers.begin() + 1});
}

}  // namespace shoal
