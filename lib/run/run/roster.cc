#include "lib/run/run/roster.h"

#include <algorithm>
#include <span>

#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

namespace {

/// Names are the same without regard to case.
bool Contains(const std::vector<std::string>& names, std::string_view name) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& each) { return LowerCase(each) == LowerCase(name); });
}

}  // namespace

std::string ParticipantName(std::string_view app, std::string_view vehicle) {
  return std::string(app) + "_" + std::string(vehicle);
}

std::vector<std::string> VehicleNames(const Mission& mission) {
  std::vector<std::string> names;
  for (const Vehicle& vehicle : mission.vehicles) names.push_back(vehicle.name);
  return names;
}

std::vector<RosterEntry> MakeRoster(const Mission& mission, bool with_recorder) {
  std::vector<RosterEntry> roster;
  const auto add = [&](std::string_view app, const std::string& vehicle, Provider provider) {
    if (provider == Provider::kNone) return;
    roster.push_back({.name = vehicle.empty() ? std::string(app) : ParticipantName(app, vehicle),
                      .app = std::string(app),
                      .vehicle = vehicle,
                      .provider = provider,
                      .command = {}});
  };
  if (with_recorder) add("recorder", "", Provider::kShoal);
  add("shore_broker", "", mission.broker);
  if (mission.netsim) add("netsim_manager", "", Provider::kShoal);
  for (size_t place = 0; place < mission.vehicles.size(); ++place) {
    const Vehicle& vehicle = mission.vehicles[place];
    const size_t first = roster.size();
    add("vehicle_sim", vehicle.name, vehicle.sim);
    add("helm", vehicle.name, vehicle.helm);
    add("node_reporter", vehicle.name, vehicle.reporter);
    if (mission.SwarmOf(vehicle) != nullptr) add("acomms", vehicle.name, vehicle.acomms);
    if (vehicle.media.gateway.exists) add("gateway", vehicle.name, Provider::kShoal);
    for (RosterEntry& entry : std::span(roster).subspan(first)) entry.vehicle_place = place;
  }
  for (const Participant& participant : mission.participants) {
    roster.push_back({.name = participant.name,
                      .app = {},
                      .vehicle = {},
                      .provider = participant.command.empty() ? Provider::kHand : Provider::kShoal,
                      .command = participant.command});
  }
  for (RosterEntry& entry : roster) {
    const auto runs_it = [&](const HostOptions& host) {
      return entry.app.empty() ? Contains(host.participants, entry.name)
                               : Contains(host.vehicles, entry.vehicle);
    };
    const auto host = std::find_if(mission.hosts.begin(), mission.hosts.end(), runs_it);
    if (host != mission.hosts.end()) entry.host = host->name;
  }
  return roster;
}

}  // namespace shoal
