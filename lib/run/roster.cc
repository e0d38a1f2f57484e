#include "lib/run/roster.h"

#include <span>

namespace shoal {

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
  return roster;
}

}  // namespace shoal
