#include "lib/mission/validate.h"

#include <algorithm>

#include "lib/mission/suggest.h"

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

std::vector<const Vehicle*> VehiclesNamed(const Mission& mission, std::string_view name_or_all) {
  std::vector<const Vehicle*> found;
  if (name_or_all != "all") {
    if (const Vehicle* vehicle = mission.FindVehicle(name_or_all)) found.push_back(vehicle);
    return found;
  }
  for (const Vehicle& vehicle : mission.vehicles) found.push_back(&vehicle);
  return found;
}

void Validate(Mission& mission, const TablePlace& file) {
  ResolveNames(mission, file);
  CompleteMission(mission, file);
  ValidateNames(mission, file);
  ValidateEnvironment(mission, file);
  ValidateAcoustics(mission, file);
  ValidateAcousticReports(mission, file);
  ValidateSwarm(mission, file);
  ValidateNetsim(mission, file);
  ValidateUnderwater(mission, file);
  ValidateBehaviors(mission, file);
  ValidateEvents(mission, file);
  WarnOfIdleTasks(mission, file);
  ValidateExpectations(mission, file);
  WarnOfConduct(mission, file);
  std::stable_sort(mission.events.begin(), mission.events.end(),
                   [](const Event& a, const Event& b) { return a.at_s < b.at_s; });
}

}  // namespace shoal
