#include "lib/broker/broker_setup.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>

#include "lib/mission/load_acoustics.h"
#include "lib/routing/control.h"
#include "lib/routing/vehicle_name.h"

namespace shoal {

BrokerSetup SetupOf(const Mission& mission) {
  BrokerSetup setup{
      .rules = mission.comms,
      .seed = mission.seed,
      .start_utime = mission.start_utime,
      .tick_us = mission.tick_us,
      .vehicles = {},
      .factors = {},
      .acoustics = mission.acoustics,
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

std::optional<Medium> MediumCalled(std::string_view text) {
  for (const auto& [word, medium] : kMedia) {
    if (word == text) return medium;
  }
  return std::nullopt;
}

std::string TextOf(Medium medium) {
  return std::string(kMedia.at(static_cast<size_t>(medium)).first);
}

/// What the rules tell of the acoustic network and of the Earth, or why it cannot be.
std::optional<Error> TakeAcoustics(const comms_rules_t& rules, BrokerSetup* setup) {
  const auto reports_over = MediumCalled(rules.reports_over);
  const auto messages_over = MediumCalled(rules.messages_over);
  if (!reports_over || !messages_over) {
    return Error{"COMMS_RULES: reports_over and messages_over are direct or acoustic"};
  }
  setup->rules.reports_over = *reports_over;
  setup->rules.messages_over = *messages_over;
  LoadedAcoustics loaded = LoadAcousticsText(rules.acoustics, "COMMS_RULES acoustics");
  if (!loaded.errors.empty()) return Error{loaded.errors.front()};
  setup->acoustics = std::move(loaded.acoustics);
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
  BrokerSetup setup{.rules = {.comms_range_m = rules.comms_range_m,
                              .critical_range_m = rules.critical_range_m,
                              .stale_time_s = rules.stale_time_s,
                              .stale_forget_s = rules.stale_forget_s,
                              .groups = rules.groups != 0,
                              .msg_groups = rules.msg_groups != 0,
                              .ignore_group = rules.ignore_group,
                              .min_rpt_interval_s = rules.min_rpt_interval_s,
                              .min_msg_interval_s = rules.min_msg_interval_s,
                              .max_msg_length_bytes = rules.max_msg_length_bytes,
                              .drop_percentage = rules.drop_percentage,
                              .shared_node_reports_s = rules.shared_node_reports_s,
                              .pulse_duration_s = rules.pulse_duration_s,
                              .view_node_rpt_pulses = rules.view_node_rpt_pulses != 0,
                              .msg_color = rules.msg_color,
                              .msg_repeat_color = rules.msg_repeat_color,
                              .each_fate_up_to = rules.each_fate_up_to},
                    .seed = static_cast<uint64_t>(rules.seed),
                    .start_utime = rules.utime,
                    .tick_us = rules.tick_us,
                    .vehicles = rules.vehicles,
                    .factors = {}};
  for (const ControlRow& row : ControlTable()) {
    if (row.of_vehicle) continue;
    const double value = GetRule(row, setup.rules);
    if (!IsPossible(row, value)) {
      return Error{fmt::format("COMMS_RULES: {} = {} is impossible", row.rule, value)};
    }
  }
  if (std::isnan(rules.stale_forget_s)) {
    return Error{"COMMS_RULES: stale_forget_s = nan is impossible"};
  }
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
  if (const auto error = TakeAcoustics(rules, &setup)) return *error;
  return setup;
}

comms_rules_t RulesMessage(const BrokerSetup& setup, const Router& router) {
  const RoutingRules& rules = router.rules();
  comms_rules_t message;
  message.utime = 0;
  message.is_start = 0;
  message.seed = static_cast<int64_t>(setup.seed);
  message.tick_us = setup.tick_us;
  message.vehicles = setup.vehicles;
  message.num_vehicles = static_cast<int32_t>(setup.vehicles.size());
  message.comms_range_m = rules.comms_range_m;
  message.critical_range_m = rules.critical_range_m;
  message.stale_time_s = rules.stale_time_s;
  message.stale_forget_s = rules.stale_forget_s;
  message.groups = rules.groups ? 1 : 0;
  message.msg_groups = rules.msg_groups ? 1 : 0;
  message.ignore_group = rules.ignore_group;
  message.min_rpt_interval_s = rules.min_rpt_interval_s;
  message.min_msg_interval_s = rules.min_msg_interval_s;
  message.max_msg_length_bytes = rules.max_msg_length_bytes;
  message.drop_percentage = rules.drop_percentage;
  message.shared_node_reports_s = rules.shared_node_reports_s;
  message.pulse_duration_s = rules.pulse_duration_s;
  message.view_node_rpt_pulses = rules.view_node_rpt_pulses ? 1 : 0;
  message.msg_color = rules.msg_color;
  message.msg_repeat_color = rules.msg_repeat_color;
  message.each_fate_up_to = rules.each_fate_up_to;
  message.origin_lat_deg = setup.origin.lat_deg;
  message.origin_lon_deg = setup.origin.lon_deg;
  message.reports_over = TextOf(rules.reports_over);
  message.messages_over = TextOf(rules.messages_over);
  message.acoustics = ExplainAcoustics(setup.acoustics);
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
