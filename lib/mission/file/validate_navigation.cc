// Whether vehicles can navigate as the file wants: beacons, and what takes ranges to them.
#include <algorithm>
#include <set>
#include <string>
#include <variant>

#include "lib/base/text/letters.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/model/names.h"
#include "lib/mission/model/swarm_plan.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

bool TakesRanges(const Vehicle& vehicle) {
  return vehicle.navigation.is_fitted && vehicle.navigation.ranging.fitted;
}

/// Refuses tasks that wait for fixes which never come.
void CheckTasks(const Vehicle& vehicle, const TablePlace& place) {
  if (vehicle.navigation.is_fitted && vehicle.navigation.gps.fitted) return;
  for (size_t i = 0; i < vehicle.tasks.size(); ++i) {
    if (!std::holds_alternative<SurfaceForFixTask>(vehicle.tasks[i].what)) continue;
    place.Below("task", i).Refuse(
        "kind",
        "without GPS there is no fix to come up for: write [vehicle.navigation] under the "
        "[[vehicle]], with gps.fitted = true");
  }
}

}  // namespace

void ValidateNavigation(const Mission& mission, const TablePlace& file) {
  std::set<std::string> names;
  for (size_t i = 0; i < mission.beacons.size(); ++i) {
    const BeaconOptions& beacon = mission.beacons[i];
    const TablePlace place = file.Below("beacon", i);
    if (!beacon.name.empty() && !names.insert(LowerCase(beacon.name)).second) {
      place.Refuse("name", "a beacon " + Quoted(beacon.name) +
                               " exists already; names must differ in more than case");
    }
    if (beacon.kind == "packets" && !PacketAcousticsOf(mission).is_used) {
      place.Refuse("kind",
                   "there are no packets without an acoustic network: write [acoustics], or "
                   "kind = \"one_way\"");
    }
  }
  const bool are_used = std::any_of(mission.vehicles.begin(), mission.vehicles.end(), TakesRanges);
  if (!mission.beacons.empty() && !are_used) {
    file.Below("beacon", 0).Warn("", "no vehicle takes ranges: give one [vehicle.navigation]");
  }
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    CheckTasks(vehicle, file.Below("vehicle", i));
    if (!vehicle.navigation.is_fitted || vehicle.sim != Provider::kNone) continue;
    file.Below("vehicle", i)
        .Refuse("navigation",
                "its filter runs in vehicle_sim, which this vehicle does not have: leave "
                "[vehicle.navigation] out");
  }
}

}  // namespace shoal
