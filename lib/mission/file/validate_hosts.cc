// [[host]]: names, and which vehicle or participant runs on which computer.
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

/// Refuses what no table has, and what another host runs already. `placed`: the host by the name in
/// lower case, over all hosts.
void CheckPlaced(const TablePlace& place, std::string_view key, const HostOptions& host,
                 const std::vector<std::string>& names, const std::vector<std::string_view>& known,
                 std::map<std::string, std::string>* placed) {
  const std::string kind = key == "vehicles" ? "vehicle" : "participant";
  std::set<std::string> known_names;
  for (const std::string_view each : known) known_names.insert(LowerCase(each));
  for (const std::string& name : names) {
    if (!known_names.contains(LowerCase(name))) {
      place.Refuse(key,
                   "the mission has no " + kind + " " + Quoted(name) + DidYouMean(name, known));
    } else if (const auto [at, is_new] = placed->emplace(LowerCase(name), host.name); !is_new) {
      place.Refuse(key, kind + " " + Quoted(name) + " is on host " + Quoted(at->second) +
                            " already: it runs on one computer");
    }
  }
}

}  // namespace

void ValidateHosts(const Mission& mission, const TablePlace& file) {
  std::set<std::string> taken;
  std::map<std::string, std::string> vehicles_placed;
  std::map<std::string, std::string> participants_placed;
  std::vector<std::string_view> vehicles;
  std::vector<std::string_view> participants;
  for (const Vehicle& vehicle : mission.vehicles) vehicles.push_back(vehicle.name);
  for (const Participant& each : mission.participants) participants.push_back(each.name);
  for (size_t i = 0; i < mission.hosts.size(); ++i) {
    const HostOptions& host = mission.hosts[i];
    const TablePlace place = file.Below("host", i);
    if (const std::string problem = NameProblem(host.name); !problem.empty()) {
      place.Refuse("name", problem);
    } else if (!taken.insert(LowerCase(host.name)).second) {
      place.Refuse("name", "a host " + Quoted(host.name) +
                               " exists already; names must differ in more than case");
    }
    CheckPlaced(place, "vehicles", host, host.vehicles, vehicles, &vehicles_placed);
    CheckPlaced(place, "participants", host, host.participants, participants, &participants_placed);
  }
}

}  // namespace shoal
