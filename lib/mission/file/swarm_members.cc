// Which vehicles [swarm] or each [[swarm]] has, and what separates the swarms: their group_id.
#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/mission/file/validate.h"

namespace shoal {
namespace {

constexpr std::string_view kGroupIds =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789abcdefghijklmnopqrstuvwxyz";

/// Returns the vehicles that follow the leader by what the acoustic network lets through.
std::vector<std::string> AcousticFollowers(const Mission& mission, const std::string& leader) {
  std::vector<std::string> followers;
  for (const Vehicle& vehicle : mission.vehicles) {
    const bool follows =
        std::any_of(vehicle.tasks.begin(), vehicle.tasks.end(), [&](const Task& task) {
          const auto* track = std::get_if<TargetTrackTask>(&task.what);
          if (track == nullptr || track->swarm != SwarmKnowledge::kAcoustic) return false;
          return mission.FindVehicle(track->target) == mission.FindVehicle(leader);
        });
    if (follows && vehicle.name != leader) followers.push_back(vehicle.name);
  }
  return followers;
}

/// Makes followers of the vehicles that `members` or `group` names; the leader may be among them.
void TakeMembers(const Mission& mission, SwarmOptions* swarm) {
  std::vector<std::string> names = std::move(swarm->members);
  if (!swarm->group.empty()) {
    for (const Vehicle* each : mission.VehiclesNamed(swarm->group)) names.push_back(each->name);
  }
  swarm->members.clear();
  swarm->group.clear();
  std::erase(names, swarm->leader);
  swarm->followers = std::move(names);
}

/// The leader of a swarm is one of the network too.
void LetLead(const Vehicle* leader, Mission* mission, const TablePlace& file) {
  for (size_t i = 0; i < mission->vehicles.size(); ++i) {
    Vehicle& vehicle = mission->vehicles[i];
    if (&vehicle != leader) continue;
    const TablePlace place = file.Below("vehicle", i);
    if (!vehicle.acoustic_leader && place.Has("acoustic_leader")) {
      place.Warn("acoustic_leader",
                 "acoustic_leader = false has no effect: " + vehicle.name +
                     " is the leader of [swarm], which always has it: leave it out");
    }
    vehicle.acoustic_leader = true;
  }
}

/// Gives those of several swarms that name none a letter of their own, in the order of the file.
void FillInGroupIds(Mission* mission, const TablePlace& file) {
  std::string taken;
  for (size_t i = 0; i < mission->swarms.size(); ++i) {
    if (TableOfSwarm(*mission, file, i).Has("group_id")) taken += mission->swarms[i].group_id;
  }
  for (size_t i = 0; i < mission->swarms.size(); ++i) {
    if (TableOfSwarm(*mission, file, i).Has("group_id")) continue;
    const size_t free = kGroupIds.find_first_not_of(taken);
    if (free == std::string_view::npos) return;  // Two have the same, which is refused.
    mission->swarms[i].group_id = kGroupIds[free];
    taken += kGroupIds[free];
  }
}

}  // namespace

TablePlace TableOfSwarm(const Mission& mission, const TablePlace& file, size_t i) {
  const bool are_many = mission.swarms.size() > 1 || !mission.swarms[i].name.empty();
  return are_many ? file.Below("swarm", i) : file.Below("swarm");
}

void ResolveSwarms(Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.swarms.size(); ++i) {
    SwarmOptions& swarm = mission.swarms[i];
    const TablePlace place = TableOfSwarm(mission, file, i);
    ResolveVehicle(place, "leader", swarm.leader, mission, false);
    if (!swarm.group.empty()) {
      swarm.group = "group:" + swarm.group;
      ResolveAddressees(place, "group", swarm.group, mission);
    }
    if (mission.FindVehicle(swarm.leader) == nullptr) continue;
    for (std::string& name : swarm.followers) {
      ResolveVehicle(place, "followers", name, mission, false);
    }
    for (std::string& name : swarm.members) ResolveVehicle(place, "members", name, mission, false);
  }
}

void FillInSwarms(Mission& mission, const TablePlace& file) {
  if (mission.swarms.size() > 1) FillInGroupIds(&mission, file);
  for (size_t i = 0; i < mission.swarms.size(); ++i) {
    SwarmOptions& swarm = mission.swarms[i];
    const Vehicle* leader = mission.FindVehicle(swarm.leader);
    if (leader == nullptr) continue;
    LetLead(leader, &mission, file);
    if (!swarm.members.empty() || !swarm.group.empty()) {
      TakeMembers(mission, &swarm);
    } else if (!TableOfSwarm(mission, file, i).Has("followers")) {
      swarm.followers = AcousticFollowers(mission, swarm.leader);
    }
  }
}

}  // namespace shoal
