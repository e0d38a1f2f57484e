#include "lib/run/broker/comms_rules_of_0_2.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace shoal {

namespace {

/// Under which key a member of comms_rules_t is a rule. The type is published: no row is ever
/// added.
struct OldRule {
  std::string_view key;
  std::variant<double comms_rules_t::*, int8_t comms_rules_t::*, int64_t comms_rules_t::*,
               std::string comms_rules_t::*>
      member;
};

constexpr std::array kOldRules = {
    OldRule{"comms_range", &comms_rules_t::comms_range_m},
    OldRule{"critical_range", &comms_rules_t::critical_range_m},
    OldRule{"stale_time", &comms_rules_t::stale_time_s},
    OldRule{"stale_forget_s", &comms_rules_t::stale_forget_s},
    OldRule{"groups", &comms_rules_t::groups},
    OldRule{"msg_groups", &comms_rules_t::msg_groups},
    OldRule{"ignore_group", &comms_rules_t::ignore_group},
    OldRule{"min_rpt_interval", &comms_rules_t::min_rpt_interval_s},
    OldRule{"min_msg_interval", &comms_rules_t::min_msg_interval_s},
    OldRule{"max_msg_length", &comms_rules_t::max_msg_length_bytes},
    OldRule{"drop_percentage", &comms_rules_t::drop_percentage},
    OldRule{"reports_over", &comms_rules_t::reports_over},
    OldRule{"messages_over", &comms_rules_t::messages_over},
    OldRule{"shared_node_reports", &comms_rules_t::shared_node_reports_s},
    OldRule{"pulse_duration", &comms_rules_t::pulse_duration_s},
    OldRule{"view_node_rpt_pulses", &comms_rules_t::view_node_rpt_pulses},
    OldRule{"msg_color", &comms_rules_t::msg_color},
    OldRule{"msg_repeat_color", &comms_rules_t::msg_repeat_color},
    OldRule{"each_fate_up_to", &comms_rules_t::each_fate_up_to},
};

struct AsRule {
  const comms_rules_t& old;
  std::string_view key;

  broker_rule_t Number(double number, std::string_view kind) const {
    return {.key = std::string(key),
            .vehicle = {},
            .kind = std::string(kind),
            .number = number,
            .text = {}};
  }
  broker_rule_t operator()(double comms_rules_t::*member) const {
    return Number(old.*member, "number");
  }
  broker_rule_t operator()(int64_t comms_rules_t::*member) const {
    return Number(static_cast<double>(old.*member), "number");
  }
  broker_rule_t operator()(int8_t comms_rules_t::*member) const {
    return Number(old.*member != 0 ? 1 : 0, "flag");
  }
  broker_rule_t operator()(std::string comms_rules_t::*member) const {
    return {
        .key = std::string(key), .vehicle = {}, .kind = "text", .number = 0, .text = old.*member};
  }
};

}  // namespace

broker_rules_t AsBrokerRules(const comms_rules_t& old) {
  broker_rules_t rules{};
  rules.utime = old.utime;
  rules.is_start = old.is_start;
  rules.seed = old.seed;
  rules.tick_us = old.tick_us;
  rules.origin_lat_deg = old.origin_lat_deg;
  rules.origin_lon_deg = old.origin_lon_deg;
  rules.acoustics = old.acoustics;
  for (size_t i = 0; i < old.vehicles.size(); ++i) {
    rules.vehicles.push_back({.name = old.vehicles[i],
                              .acoustic_address = old.acoustic_addresses[i],
                              .is_acoustic_leader = old.acoustic_leaders[i]});
  }
  for (const OldRule& each : kOldRules) {
    rules.rules.push_back(std::visit(AsRule{old, each.key}, each.member));
  }
  for (const link_factors_t& each : old.factors) {
    for (const auto& [key, number] :
         {std::pair("stealth", each.stealth), std::pair("earange", each.earange)}) {
      rules.rules.push_back(
          {.key = key, .vehicle = each.vehicle, .kind = "number", .number = number, .text = {}});
    }
  }
  rules.num_vehicles = static_cast<int32_t>(rules.vehicles.size());
  rules.num_rules = static_cast<int32_t>(rules.rules.size());
  return rules;
}

}  // namespace shoal
