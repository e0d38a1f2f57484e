#include "lib/run/broker/broker_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "lib/base/arithmetic/arithmetic_id.h"
#include "lib/comms/routing/control.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/file/ocean_of.h"
#include "lib/mission/file/ray_surroundings.h"

namespace shoal {

bool BrokerSetup::HasRays() const {
  return std::ranges::any_of(
      media.Networks(), [](const Acoustics* network) { return network->options.rays.has_value(); });
}

RaySurroundings BrokerSetup::SurroundingsOf(const Acoustics& acoustics) const {
  RaySurroundings surroundings;
  const std::optional<RayChannelOptions>& rays = acoustics.options.rays;
  if (!rays) return surroundings;
  if (rays->follows_floor) surroundings.floor = floor;
  const auto found = this->arrivals.find(rays->arrivals_file);
  if (found != this->arrivals.end()) surroundings.arrivals = found->second;
  return surroundings;
}

std::string BrokerSetup::MissingOf(const Acoustics& acoustics) const {
  const std::optional<RayChannelOptions>& rays = acoustics.options.rays;
  if (!rays) return "";
  if (rays->follows_floor && !floor) {
    return "channel: the sea floor that it follows is a grid in a file, and cannot be read here; "
           "give the mission file";
  }
  if (!rays->arrivals_file.empty() && !arrivals.contains(rays->arrivals_file)) {
    return fmt::format("channel: the arrivals of {} cannot be read here; give the mission file",
                       rays->arrivals_file);
  }
  return "";
}

namespace {

/// Reads what channels of sound name. A mission that loaded has all of it, unless a file has gone
/// since: MissingOf() then has the reason.
void ReadSurroundings(const Mission& mission, BrokerSetup* setup) {
  for (const Acoustics* network : setup->media.Networks()) {
    const std::optional<RayChannelOptions>& rays = network->options.rays;
    if (!rays) continue;
    const Result<RaySurroundings> read = SurroundingsOf(mission, *rays);
    if (!read.ok()) continue;
    if (read->floor) setup->floor = read->floor;
    if (read->arrivals != nullptr) setup->arrivals[rays->arrivals_file] = read->arrivals;
  }
}

/// Makes the sea floor that a log describes; a grid is in a file that a log does not have.
void MakeFloor(BrokerSetup* setup) {
  if (!setup->media.floor || setup->media.floor->style == "grid") return;
  Environment environment;
  environment.floor = *setup->media.floor;
  const Result<Ocean> ocean = OceanOf(environment, setup->seed, {});
  if (ocean.ok()) setup->floor = ocean->floor;
}

}  // namespace

BrokerSetup SetupOf(const Mission& mission) {
  BrokerSetup setup{
      .rules = mission.comms,
      .seed = mission.seed,
      .start_utime = mission.start_utime,
      .tick_us = mission.tick_us,
      .vehicles = {},
      .factors = {},
      .media = MediaOf(mission),
      .nodes = {},
      .origin = {.lat_deg = mission.origin_lat_deg, .lon_deg = mission.origin_lon_deg}};
  for (const Vehicle& vehicle : mission.vehicles) {
    setup.vehicles.push_back(vehicle.name);
    setup.nodes.push_back({.name = vehicle.name,
                           .address = vehicle.acoustic_address,
                           .is_leader = vehicle.acoustic_leader});
    if (vehicle.link_factors == LinkFactors()) continue;
    setup.factors.emplace_back(vehicle.name, vehicle.link_factors);
  }
  ReadSurroundings(mission, &setup);
  return setup;
}

namespace {

/// Takes the media and the origin, or returns why they cannot be.
std::optional<Error> TakeMedia(const BrokerRules& rules, BrokerSetup* setup) {
  LoadedMedia loaded = LoadMediaText(rules.media, "COMMS_RULES acoustics");
  if (!loaded.errors.empty()) return Error{loaded.errors.front()};
  setup->media = std::move(loaded.setup);
  const size_t num_with_media = setup->media.of_vehicles.size();
  if (num_with_media != 0 && num_with_media != setup->vehicles.size()) {
    return Error{fmt::format("COMMS_RULES: media of {} vehicles, where there are {}",
                             num_with_media, setup->vehicles.size())};
  }
  if (const std::string impossible = ImpossibleRule(rules.rules, setup->media.Names());
      !impossible.empty()) {
    return Error{fmt::format("COMMS_RULES: {} is impossible", impossible)};
  }
  for (const AcousticNode& node : rules.vehicles) {
    if (node.address <= 0) {
      return Error{fmt::format("COMMS_RULES: {} is not an acoustic address", node.address)};
    }
  }
  setup->nodes = rules.vehicles;
  if (!(std::abs(rules.origin.lat_deg) <= 90) || !(std::abs(rules.origin.lon_deg) <= 180)) {
    return Error{fmt::format("COMMS_RULES: no place of the Earth: {}, {}", rules.origin.lat_deg,
                             rules.origin.lon_deg)};
  }
  setup->origin = rules.origin;
  return std::nullopt;
}

/// True where each factor has a value that its rule can have.
bool ArePossible(const LinkFactors& factors) {
  return std::ranges::all_of(ControlTable(), [&](const ControlRow& row) {
    return !row.of_vehicle || row.type == ControlType::kRequest ||
           IsPossible(row, GetFactor(row, factors));
  });
}

}  // namespace

Result<BrokerSetup> SetupOf(const BrokerRules& rules) {
  if (!rules.wrong.empty()) return Error{"COMMS_RULES: " + rules.wrong.front()};
  BrokerSetup setup;
  setup.rules = rules.rules;
  setup.seed = static_cast<uint64_t>(rules.seed);
  setup.start_utime = rules.utime;
  setup.tick_us = rules.tick_us;
  constexpr int64_t kLongestTick_us = 1'000'000'000;
  if (rules.tick_us <= 0 || rules.tick_us > kLongestTick_us) {
    return Error{fmt::format("COMMS_RULES: tick_us = {} is impossible", rules.tick_us)};
  }
  std::set<std::string> keys;
  for (const AcousticNode& node : rules.vehicles) {
    if (!IsLegalVehicleName(node.name) || !keys.insert(VehicleKey(node.name)).second) {
      return Error{fmt::format("COMMS_RULES: illegal or repeated vehicle '{}'", node.name)};
    }
    setup.vehicles.push_back(node.name);
  }
  for (const auto& [vehicle, factors] : rules.factors) {
    if (!ArePossible(factors)) {
      return Error{fmt::format("COMMS_RULES: impossible factors of '{}'", vehicle)};
    }
  }
  setup.factors = rules.factors;
  if (const auto error = TakeMedia(rules, &setup)) return *error;
  MakeFloor(&setup);
  return setup;
}

BrokerRules RulesNow(const BrokerSetup& setup, const Router& router) {
  BrokerRules now{.seed = static_cast<int64_t>(setup.seed),
                  .tick_us = setup.tick_us,
                  .origin = setup.origin,
                  .vehicles = setup.nodes,
                  .rules = router.rules(),
                  .media = ExplainMedia(setup.media),
                  .arithmetic = ArithmeticId()};
  for (const Contact* contact : router.contacts()) {
    if (contact->factors == LinkFactors()) continue;
    now.factors.emplace_back(contact->name, contact->factors);
  }
  return now;
}

}  // namespace shoal
