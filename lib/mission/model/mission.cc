#include "lib/mission/model/mission.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/text/letters.h"
#include "lib/base/time/seconds.h"
#include "lib/mission/model/names.h"

namespace shoal {

Mission::Mission() = default;
Mission::~Mission() = default;
Mission::Mission(const Mission&) = default;
Mission::Mission(Mission&&) noexcept = default;
Mission& Mission::operator=(const Mission&) = default;
Mission& Mission::operator=(Mission&&) noexcept = default;
bool Mission::operator==(const Mission&) const = default;

int64_t Mission::LastStep() const {
  SHOAL_CHECK(tick_us > 0, "a step must move time forward");
  return Microseconds(duration_s) / tick_us;
}

const Vehicle* Mission::FindVehicle(std::string_view vehicle_name) const {
  const auto found = std::find_if(vehicles.begin(), vehicles.end(), [&](const Vehicle& vehicle) {
    return IsSameWord(vehicle.name, vehicle_name);
  });
  return found == vehicles.end() ? nullptr : &*found;
}

std::vector<const Vehicle*> Mission::VehiclesNamed(std::string_view addressees) const {
  const std::optional<std::string_view> group = GroupNamed(addressees);
  const bool is_all = IsSameWord(addressees, "all");
  std::vector<const Vehicle*> named;
  for (const Vehicle& vehicle : vehicles) {
    const bool is_named = group ? !vehicle.group.empty() && IsSameWord(vehicle.group, *group)
                                : is_all || IsSameWord(vehicle.name, addressees);
    if (is_named) named.push_back(&vehicle);
  }
  return named;
}

bool Mission::MayBeSteeredFromOutside() const {
  const bool has_other_helm =
      std::any_of(vehicles.begin(), vehicles.end(), [](const Vehicle& vehicle) {
        return vehicle.helm != Provider::kShoal && FactsOfModel(vehicle.model).passive.empty();
      });
  return has_other_helm || !participants.empty() || netsim.has_value();
}

bool Mission::IsReported(const Vehicle& vehicle) const {
  if (vehicle.reporter != Provider::kNone) return true;
  return netsim &&
         std::any_of(netsim->vehicles.begin(), netsim->vehicles.end(),
                     [&](const NetsimVehicle& each) { return each.name == vehicle.name; });
}

bool Mission::HasMedia() const {
  return !media.empty() || std::any_of(vehicles.begin(), vehicles.end(), [](const Vehicle& each) {
    return !each.media.names.empty() || each.media.gateway.exists;
  });
}

const SwarmOptions* Mission::SwarmOf(const Vehicle& vehicle) const {
  const auto found = std::ranges::find_if(swarms, [&](const SwarmOptions& swarm) {
    return vehicle.name == swarm.leader ||
           std::ranges::find(swarm.followers, vehicle.name) != swarm.followers.end();
  });
  return found == swarms.end() ? nullptr : &*found;
}

std::map<std::string, std::vector<std::string>> GroupsOf(const Mission& mission) {
  std::map<std::string, std::vector<std::string>> groups;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (vehicle.group.empty()) continue;
    const auto first =
        std::find_if(mission.vehicles.begin(), mission.vehicles.end(),
                     [&](const Vehicle& each) { return IsSameWord(each.group, vehicle.group); });
    groups[first->group].push_back(vehicle.name);
  }
  return groups;
}

std::vector<OrderWords> OrdersOf(const Mission& mission) {
  std::vector<OrderWords> orders;
  for (const auto& [name, command] : mission.orders) {
    OrderWords order{.name = name, .target = command.vehicle, .words = {command.command}};
    if (!command.argument.empty()) order.words.push_back(command.argument);
    for (const double value : command.values) order.words.push_back(fmt::format("{}", value));
    orders.push_back(std::move(order));
  }
  return orders;
}

}  // namespace shoal
