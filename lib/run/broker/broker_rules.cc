#include "lib/run/broker/broker_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <type_traits>
#include <variant>

#include "lib/bus/bus/bus.h"
#include "lib/comms/routing/control.h"
#include "lib/run/broker/comms_rules_of_0_2.h"
#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

/// Whole numbers up to this are doubles without loss.
constexpr double kLargestWhole = 9007199254740992;

consteval bool AreWholeRulesDoubles() {
  return std::ranges::all_of(kRuleTable, [](const RuleRow& row) {
    return row.type != RuleType::kWhole ||
           (row.in_file.max <= kLargestWhole && row.max <= kLargestWhole);
  });
}
static_assert(AreWholeRulesDoubles(), "COMMS_RULES carries whole numbers as doubles");

/// Requests change nothing that lasts.
constexpr bool HasValue(const RuleRow& row) { return row.type != RuleType::kRequest; }

const RuleRow* FindRule(std::string_view key) {
  const auto found = std::ranges::find(kRuleTable, key, &RuleRow::rule);
  return found == kRuleTable.end() || !HasValue(*found) ? nullptr : &*found;
}

/// The kinds of a broker_rule_t.
std::string_view KindOf(RuleType type) {
  switch (type) {
    case RuleType::kNumber:
    case RuleType::kWhole:
      return "number";
    case RuleType::kYesNo:
      return "flag";
    case RuleType::kText:
    case RuleType::kMedia:
      return "text";
    case RuleType::kRequest:
      break;
  }
  return {};
}

/// Returns the value of a rule that is not of a vehicle.
ControlValue ValueOf(const RuleRow& row, const RoutingRules& rules) {
  if (const auto* media = std::get_if<MediaChoice RoutingRules::*>(&row.member)) {
    return TextOf(rules.**media);
  }
  return GetRule(row, rules);
}

broker_rule_t RuleOf(const RuleRow& row, std::string_view vehicle, ControlValue value) {
  return {.key = std::string(row.rule),
          .vehicle = std::string(vehicle),
          .kind = std::string(KindOf(row.type)),
          .number = value.number,
          .text = std::move(value.text)};
}

/// Returns the value as a log's reader sees it.
std::string WordOf(const broker_rule_t& rule) {
  if (rule.kind == "text") return fmt::format("'{}'", Printable(rule.text));
  if (rule.kind == "flag") return rule.number != 0 ? "true" : "false";
  return fmt::format("{}", rule.number);
}

/// Takes a message's list of rules, one after the other.
class RuleReader {
 public:
  explicit RuleReader(BrokerRules* rules) : rules_(*rules) {}

  void Take(const broker_rule_t& each) {
    const RuleRow* row = FindRule(each.key);
    if (row == nullptr) {
      rules_.unknown.push_back(each);
    } else if (row->of_vehicle == each.vehicle.empty()) {
      Refuse(*row, row->of_vehicle ? "is without a vehicle" : "is of one vehicle");
    } else if (each.kind != KindOf(row->type)) {
      Refuse(*row, fmt::format("is a {}, not a {}", Printable(each.kind), KindOf(row->type)));
    } else if (row->type == RuleType::kWhole && !IsWhole(each.number)) {
      Refuse(*row, fmt::format("= {} is not a whole number", each.number));
    } else if (!taken_.emplace(row->rule, each.vehicle).second) {
      Refuse(*row, "is given twice");
    } else if (row->of_vehicle) {
      SetFactor(*row, each.number, FactorsOf(each.vehicle));
    } else if (const auto* media = std::get_if<MediaChoice RoutingRules::*>(&row->member)) {
      rules_.rules.** media = Over(each.text);
    } else {
      SetRule(*row, row->type == RuleType::kText ? ControlValue(each.text) : each.number,
              &rules_.rules);
    }
  }

  /// Gives what was not taken its default.
  void Finish() {
    for (const RuleRow& row : kRuleTable) {
      if (!HasValue(row) || row.of_vehicle || taken_.contains({row.rule, {}})) continue;
      rules_.lacking.emplace_back(row.rule);
      if (row.default_of == nullptr) continue;
      const double of = rules_.rules.*row.default_of;
      SetRule(row, of < 0 ? -1 : std::min(row.default_factor * of, row.in_file.max), &rules_.rules);
    }
  }

 private:
  static bool IsWhole(double number) {
    return std::abs(number) <= kLargestWhole && number == std::floor(number);
  }

  void Refuse(const RuleRow& row, std::string_view what) {
    rules_.wrong.push_back(fmt::format("{} {}", row.rule, what));
  }

  LinkFactors* FactorsOf(const std::string& vehicle) {
    const auto [found, is_new] = places_.try_emplace(vehicle, rules_.factors.size());
    if (is_new) rules_.factors.emplace_back(vehicle, LinkFactors());
    return &rules_.factors[found->second].second;
  }

  BrokerRules& rules_;
  std::set<std::pair<std::string_view, std::string>> taken_;
  std::map<std::string, size_t> places_;  ///< Of vehicles, in BrokerRules::factors.
};

}  // namespace

broker_rules_t ToMessage(const BrokerRules& rules) {
  broker_rules_t message{};
  message.utime = rules.utime;
  message.is_start = rules.is_start ? 1 : 0;
  message.seed = rules.seed;
  message.tick_us = rules.tick_us;
  message.origin_lat_deg = rules.origin.lat_deg;
  message.origin_lon_deg = rules.origin.lon_deg;
  message.acoustics = rules.media;
  message.arithmetic = rules.arithmetic;
  for (const AcousticNode& node : rules.vehicles) {
    message.vehicles.push_back({.name = node.name,
                                .acoustic_address = node.address,
                                .is_acoustic_leader = static_cast<int8_t>(node.is_leader)});
  }
  for (const RuleRow& row : kRuleTable) {
    if (!HasValue(row)) continue;
    if (!row.of_vehicle) message.rules.push_back(RuleOf(row, {}, ValueOf(row, rules.rules)));
  }
  for (const auto& [vehicle, factors] : rules.factors) {
    for (const RuleRow& row : kRuleTable) {
      if (!HasValue(row) || !row.of_vehicle) continue;
      message.rules.push_back(RuleOf(row, vehicle, GetFactor(row, factors)));
    }
  }
  message.num_vehicles = static_cast<int32_t>(message.vehicles.size());
  message.num_rules = static_cast<int32_t>(message.rules.size());
  return message;
}

BrokerRules FromMessage(const broker_rules_t& message) {
  BrokerRules rules{
      .utime = message.utime,
      .is_start = message.is_start != 0,
      .seed = message.seed,
      .tick_us = message.tick_us,
      .origin = {.lat_deg = message.origin_lat_deg, .lon_deg = message.origin_lon_deg},
      .media = message.acoustics,
      .arithmetic = message.arithmetic};
  for (const broker_vehicle_t& vehicle : message.vehicles) {
    rules.vehicles.push_back({.name = vehicle.name,
                              .address = vehicle.acoustic_address,
                              .is_leader = vehicle.is_acoustic_leader != 0});
  }
  RuleReader reader(&rules);
  for (const broker_rule_t& each : message.rules) reader.Take(each);
  reader.Finish();
  return rules;
}

std::optional<BrokerRules> ReadBrokerRules(std::span<const uint8_t> data) {
  if (broker_rules_t message{}; Decode(data, &message)) return FromMessage(message);
  if (comms_rules_t old{}; Decode(data, &old)) return FromMessage(AsBrokerRules(old));
  return std::nullopt;
}

std::string ImpossibleRule(const RoutingRules& rules, std::span<const std::string> media) {
  for (const RuleRow& row : kRuleTable) {
    if (!HasValue(row) || row.of_vehicle || row.type == RuleType::kText) continue;
    const ControlValue value = ValueOf(row, rules);
    if (row.type == RuleType::kMedia) {
      for (const std::string& name : Over(value.text).names) {
        if (std::ranges::find(media, name) != media.end()) continue;
        return fmt::format("{} = '{}'", row.rule, value.text.substr(0, 64));
      }
    } else if (row.channel.empty() ? std::isnan(value.number) : !IsPossible(row, value)) {
      return fmt::format("{} = {}", row.rule, value.number);
    }
  }
  return {};
}

std::vector<std::string> StrangeRules(const BrokerRules& rules) {
  constexpr size_t kMaxNamed = 20;
  std::vector<std::string> lines;
  for (const broker_rule_t& each : rules.unknown) {
    if (lines.size() == kMaxNamed) {
      lines.push_back(fmt::format("the log has {} more rules that this build does not know",
                                  rules.unknown.size() - kMaxNamed));
      break;
    }
    lines.push_back(fmt::format(
        "the log has the rule '{}' ({}{}), which this build does not know: decisions may differ",
        Printable(each.key), WordOf(each),
        each.vehicle.empty() ? "" : fmt::format(", of '{}'", Printable(each.vehicle))));
  }
  for (const std::string& key : rules.lacking) {
    const RuleRow& row = *FindRule(key);
    lines.push_back(fmt::format("the log does not have the rule '{}': it has its default, {}", key,
                                WordOf(RuleOf(row, {}, ValueOf(row, rules.rules)))));
  }
  return lines;
}

}  // namespace shoal
