// Whether the vehicles of [netsim] come from outside, and whether its table holds together.
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/validate.h"
#include "lib/netsim/netsim_options.h"

namespace shoal {
namespace {

void CheckNetsimVehicle(const NetsimVehicle& vehicle, const Mission& mission,
                        const TablePlace& place) {
  const Vehicle* simulated = mission.FindVehicle(vehicle.name);
  const bool is_elsewhere = simulated == nullptr || (simulated->sim == Provider::kNone &&
                                                     simulated->reporter == Provider::kNone);
  if (!is_elsewhere) {
    place.Refuse("name",
                 fmt::format("shoal simulates {} itself: write outside = true in its [[vehicle]]",
                             vehicle.name));
  }
  if (vehicle.modem != NetsimModem::kNone && !mission.acoustics.is_used) {
    place.Refuse("modem", "a modem sends over the acoustic network: write [acoustics] as well");
  }
}

/// `where`: as FindNetsimProblems names a table.
void RefuseAt(const TablePlace& place, std::string_view where,
              const std::vector<NetsimProblem>& problems) {
  for (const NetsimProblem& problem : problems) {
    if (problem.where != where) continue;
    const std::string key = problem.key == "gps_tcp_port" ? "gps" : problem.key;
    place.Refuse(key, problem.key + " " + problem.message);
  }
}

}  // namespace

void ValidateNetsim(const Mission& mission, const TablePlace& file) {
  if (!mission.netsim) return;
  const NetsimOptions& options = *mission.netsim;
  const TablePlace netsim = file.Below("netsim");
  for (size_t i = 0; i < options.vehicles.size(); ++i) {
    CheckNetsimVehicle(options.vehicles[i], mission, netsim.Below("vehicle", i));
  }
  if (!netsim.IsSound()) return;
  const std::vector<NetsimProblem> problems = FindNetsimProblems(options);
  RefuseAt(netsim, "netsim", problems);
  for (size_t i = 0; i < options.environments.size(); ++i) {
    RefuseAt(netsim.Below("environment", i),
             fmt::format("netsim.environment '{}'", options.environments[i].name), problems);
  }
  for (size_t i = 0; i < options.vehicles.size(); ++i) {
    RefuseAt(netsim.Below("vehicle", i),
             fmt::format("netsim.vehicle '{}'", options.vehicles[i].name), problems);
  }
}

}  // namespace shoal
