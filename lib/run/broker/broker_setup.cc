#include "lib/run/broker/broker_setup.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>

#include "lib/comms/routing/control.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/run/broker/comms_rules.h"

namespace shoal {

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
  return setup;
}

namespace {

/// Takes the media and the origin, or returns why they cannot be.
std::optional<Error> TakeMedia(const comms_rules_t& rules, BrokerSetup* setup) {
  LoadedMedia loaded = LoadMediaText(rules.acoustics, "COMMS_RULES acoustics");
  if (!loaded.errors.empty()) return Error{loaded.errors.front()};
  setup->media = std::move(loaded.setup);
  const size_t num_with_media = setup->media.of_vehicles.size();
  if (num_with_media != 0 && num_with_media != setup->vehicles.size()) {
    return Error{fmt::format("COMMS_RULES: media of {} vehicles, where there are {}",
                             num_with_media, setup->vehicles.size())};
  }
  if (const std::string impossible = ImpossibleRule(rules, setup->media.Names());
      !impossible.empty()) {
    return Error{fmt::format("COMMS_RULES: {} is impossible", impossible)};
  }
  for (size_t i = 0; i < setup->vehicles.size(); ++i) {
    if (rules.acoustic_addresses[i] <= 0) {
      return Error{
          fmt::format("COMMS_RULES: {} is no acoustic address", rules.acoustic_addresses[i])};
    }
    setup->nodes.push_back({.name = setup->vehicles[i],
                            .address = rules.acoustic_addresses[i],
                            .is_leader = rules.acoustic_leaders[i] != 0});
  }
  if (!(std::abs(rules.origin_lat_deg) <= 90) || !(std::abs(rules.origin_lon_deg) <= 180)) {
    return Error{fmt::format("COMMS_RULES: no place of the Earth: {}, {}", rules.origin_lat_deg,
                             rules.origin_lon_deg)};
  }
  setup->origin = {.lat_deg = rules.origin_lat_deg, .lon_deg = rules.origin_lon_deg};
  return std::nullopt;
}

}  // namespace

Result<BrokerSetup> SetupOf(const comms_rules_t& rules) {
  BrokerSetup setup;
  setup.rules = RulesOf(rules);
  setup.seed = static_cast<uint64_t>(rules.seed);
  setup.start_utime = rules.utime;
  setup.tick_us = rules.tick_us;
  setup.vehicles = rules.vehicles;
  constexpr int64_t kLongestTick_us = 1'000'000'000;
  if (rules.tick_us <= 0 || rules.tick_us > kLongestTick_us) {
    return Error{fmt::format("COMMS_RULES: tick_us = {} is impossible", rules.tick_us)};
  }
  std::set<std::string> keys;
  for (const std::string& name : setup.vehicles) {
    if (!IsLegalVehicleName(name) || !keys.insert(VehicleKey(name)).second) {
      return Error{fmt::format("COMMS_RULES: illegal or repeated vehicle '{}'", name)};
    }
  }
  for (const link_factors_t& each : rules.factors) {
    const LinkFactors factors = {.stealth = each.stealth, .earange = each.earange};
    if (!IsPossible(*FindControl("stealth"), factors.stealth) ||
        !IsPossible(*FindControl("earange"), factors.earange)) {
      return Error{fmt::format("COMMS_RULES: impossible factors of '{}'", each.vehicle)};
    }
    setup.factors.emplace_back(each.vehicle, factors);
  }
  if (const auto error = TakeMedia(rules, &setup)) return *error;
  return setup;
}

comms_rules_t RulesMessage(const BrokerSetup& setup, const Router& router) {
  comms_rules_t message;
  message.utime = 0;
  message.is_start = 0;
  message.seed = static_cast<int64_t>(setup.seed);
  message.tick_us = setup.tick_us;
  message.vehicles = setup.vehicles;
  message.num_vehicles = static_cast<int32_t>(setup.vehicles.size());
  PutRules(router.rules(), &message);
  message.origin_lat_deg = setup.origin.lat_deg;
  message.origin_lon_deg = setup.origin.lon_deg;
  message.acoustics = ExplainMedia(setup.media);
  for (const AcousticNode& node : setup.nodes) {
    message.acoustic_addresses.push_back(node.address);
    message.acoustic_leaders.push_back(node.is_leader ? 1 : 0);
  }
  for (const Contact* contact : router.contacts()) {
    if (contact->factors == LinkFactors()) continue;
    message.factors.push_back({.vehicle = contact->name,
                               .stealth = contact->factors.stealth,
                               .earange = contact->factors.earange});
  }
  message.num_factors = static_cast<int32_t>(message.factors.size());
  return message;
}

}  // namespace shoal
