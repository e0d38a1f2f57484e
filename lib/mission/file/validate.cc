#include "lib/mission/file/validate.h"

#include <algorithm>

#include "lib/base/text/letters.h"
#include "lib/mission/file/background_files.h"
#include "lib/mission/model/names.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

void ResolveVehicle(const TablePlace& place, std::string_view key, std::string& name,
                    const Mission& mission, bool or_all) {
  if (name.empty()) return;
  if (or_all && LowerCase(name) == "all") {
    name = "all";
    return;
  }
  if (const Vehicle* vehicle = mission.FindVehicle(name)) {
    name = vehicle->name;
    return;
  }
  std::vector<std::string_view> names;
  for (const Vehicle& vehicle : mission.vehicles) names.push_back(vehicle.name);
  std::string hint = DidYouMean(name, names);
  if (hint.empty()) {
    names.resize(std::min(names.size(), size_t{5}));
    hint = "; the mission has " + Joined(names) + (mission.vehicles.size() > 5 ? ", ..." : "");
    if (or_all) hint += ", or \"all\"";
  }
  place.Refuse(key, "unknown vehicle " + Quoted(name) + hint);
}

void ResolveAddressees(const TablePlace& place, std::string_view key, std::string& name,
                       const Mission& mission) {
  const std::optional<std::string_view> group = GroupNamed(name);
  if (!group) return ResolveVehicle(place, key, name, mission, true);
  std::vector<std::string_view> groups;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (!group->empty() && LowerCase(vehicle.group) == LowerCase(*group)) {
      name = "group:" + vehicle.group;
      return;
    }
    const bool is_new = std::find(groups.begin(), groups.end(), vehicle.group) == groups.end();
    if (!vehicle.group.empty() && is_new) groups.push_back(vehicle.group);
  }
  std::string hint = DidYouMean(*group, groups);
  if (groups.empty()) {
    hint += "; no vehicle has a group: write group = \"survey\" in its table";
  } else {
    constexpr size_t kMaxShown = 10;
    const bool has_more = groups.size() > kMaxShown;
    groups.resize(std::min(groups.size(), kMaxShown));
    hint += "; the mission has the groups " + Joined(groups) + (has_more ? ", ..." : "");
  }
  place.Refuse(key, "no vehicle is of group " + Quoted(*group) + hint);
}

std::vector<const Vehicle*> VehiclesNamed(const Mission& mission, std::string_view addressees) {
  return mission.VehiclesNamed(addressees);
}

void WarnOfBackgrounds(const Mission& mission, const TablePlace& file) {
  if (!file.Below("mission").IsSound()) return;
  for (const std::string& text : MissingBackgrounds(mission)) {
    file.Below("mission").Warn("backgrounds", text);
  }
}

void Validate(Mission& mission, const TablePlace& file) {
  ResolveNames(mission, file);
  CompleteMission(mission, file);
  SeedPaths(mission);
  ValidateNames(mission, file);
  ValidateEnvironment(mission, file);
  ValidateAcoustics(mission, file);
  ValidateChannels(mission, file);
  ValidateAcousticReports(mission, file);
  ValidateMedia(mission, file);
  ValidateSwarm(mission, file);
  ValidateNetsim(mission, file);
  ValidateUnderwater(mission, file);
  ValidatePaths(mission, file);
  ValidateBehaviors(mission, file);
  ValidateNavigation(mission, file);
  ValidateHosts(mission, file);
  ValidateEvents(mission, file);
  WarnOfAutopilots(mission, file);
  WarnOfIdleKeys(mission, file);
  WarnOfBackgrounds(mission, file);
  WarnOfIdleTasks(mission, file);
  ValidateExpectations(mission, file);
  WarnOfConduct(mission, file);
  WarnOfReach(mission, file);
  WarnOfMessages(mission, file);
  WarnOfDivers(mission, file);
  std::stable_sort(mission.events.begin(), mission.events.end(),
                   [](const Event& a, const Event& b) { return a.at_s < b.at_s; });
}

}  // namespace shoal
