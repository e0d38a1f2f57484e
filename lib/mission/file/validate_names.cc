// Names of vehicles and participants: legal, and unique without regard to case; groups.
#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/model/names.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

void CheckVehicleNames(const Mission& mission, const TablePlace& file) {
  std::map<std::string, std::string> first;  // By lower case, as first written.
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const std::string& name = mission.vehicles[i].name;
    const TablePlace place = file.Below("vehicle", i);
    if (!place.Has("name")) continue;
    const std::string problem = NameProblem(name);
    if (!problem.empty()) {
      place.Refuse("name", problem);
    } else if (const auto [at, is_new] = first.emplace(LowerCase(name), name); !is_new) {
      place.Refuse("name", "a vehicle " + Quoted(at->second) +
                               " exists already; names must differ in more than case");
    }
  }
}

/// ACOUSTIC_RX_ON_ALPHA is a channel of alpha, and would be ACOUSTIC_RX of on_alpha.
void CheckChannelNames(const Mission& mission, const TablePlace& file) {
  constexpr std::string_view kPrefix = "on_";
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const std::string name = LowerCase(mission.vehicles[i].name);
    if (!name.starts_with(kPrefix)) continue;
    const Vehicle* other = mission.FindVehicle(name.substr(kPrefix.size()));
    if (other == nullptr) continue;
    file.Below("vehicle", i)
        .Refuse("name", Quoted(mission.vehicles[i].name) + " has channels that are those of " +
                            Quoted(other->name) + ": choose another name");
  }
}

/// Names of participants must not be those of shoal's own processes.
void CheckParticipantNames(const Mission& mission, const TablePlace& file) {
  std::set<std::string> taken;
  for (size_t i = 0; i < mission.participants.size(); ++i) {
    const std::string& name = mission.participants[i].name;
    const TablePlace place = file.Below("participant", i);
    if (!place.Has("name")) continue;
    const std::string_view vehicle = VehicleOfProcess(name);
    const std::string problem = NameProblem(name);
    if (!problem.empty()) {
      place.Refuse("name", problem);
    } else if (IsOwnProcess(name) || mission.FindVehicle(vehicle) != nullptr) {
      place.Refuse("name", "the name " + Quoted(name) + " is shoal's own: choose another");
    } else if (!taken.insert(LowerCase(name)).second) {
      place.Refuse("name", "a participant " + Quoted(name) +
                               " exists already; names must differ in more than case");
    }
  }
}

/// A group without members is most likely misspelt.
void CheckIgnoredGroup(const Mission& mission, const TablePlace& file) {
  const std::string ignored = LowerCase(mission.comms.ignore_group);
  if (ignored.empty()) return;
  std::vector<std::string_view> groups;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (LowerCase(vehicle.group) == ignored) return;
    if (!vehicle.group.empty()) groups.push_back(vehicle.group);
  }
  file.Below("comms").Warn(
      "ignore_group",
      fmt::format("no vehicle of the mission is of group {}{}", Quoted(mission.comms.ignore_group),
                  DidYouMean(mission.comms.ignore_group, groups)));
}

}  // namespace

void ValidateNames(const Mission& mission, const TablePlace& file) {
  CheckVehicleNames(mission, file);
  CheckChannelNames(mission, file);
  CheckParticipantNames(mission, file);
  CheckIgnoredGroup(mission, file);
}

}  // namespace shoal
