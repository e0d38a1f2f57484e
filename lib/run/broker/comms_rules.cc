#include "lib/run/broker/comms_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "lib/base/check/check.h"
#include "lib/comms/routing/control.h"

namespace shoal {

namespace {

/// Where a rule is in COMMS_RULES.
struct WireRow {
  std::string_view rule;
  std::variant<double comms_rules_t::*, int8_t comms_rules_t::*, int64_t comms_rules_t::*,
               std::string comms_rules_t::*>
      member;
};

constexpr std::array kWire = {
    WireRow{"comms_range", &comms_rules_t::comms_range_m},
    WireRow{"critical_range", &comms_rules_t::critical_range_m},
    WireRow{"stale_time", &comms_rules_t::stale_time_s},
    WireRow{"stale_forget_s", &comms_rules_t::stale_forget_s},
    WireRow{"groups", &comms_rules_t::groups},
    WireRow{"msg_groups", &comms_rules_t::msg_groups},
    WireRow{"ignore_group", &comms_rules_t::ignore_group},
    WireRow{"min_rpt_interval", &comms_rules_t::min_rpt_interval_s},
    WireRow{"min_msg_interval", &comms_rules_t::min_msg_interval_s},
    WireRow{"max_msg_length", &comms_rules_t::max_msg_length_bytes},
    WireRow{"drop_percentage", &comms_rules_t::drop_percentage},
    WireRow{"reports_over", &comms_rules_t::reports_over},
    WireRow{"messages_over", &comms_rules_t::messages_over},
    WireRow{"shared_node_reports", &comms_rules_t::shared_node_reports_s},
    WireRow{"pulse_duration", &comms_rules_t::pulse_duration_s},
    WireRow{"view_node_rpt_pulses", &comms_rules_t::view_node_rpt_pulses},
    WireRow{"msg_color", &comms_rules_t::msg_color},
    WireRow{"msg_repeat_color", &comms_rules_t::msg_repeat_color},
    WireRow{"each_fate_up_to", &comms_rules_t::each_fate_up_to},
};

/// A vehicle's factors travel in comms_rules_t::factors.
constexpr bool IsOnTheWire(const RuleRow& row) {
  return !row.of_vehicle && row.type != RuleType::kRequest;
}

consteval bool HasEachRuleOnce() {
  size_t place = 0;
  for (const RuleRow& row : kRuleTable) {
    if (!IsOnTheWire(row)) continue;
    if (place == kWire.size() || kWire[place++].rule != row.rule) return false;
  }
  return place == kWire.size();
}
static_assert(HasEachRuleOnce(), "COMMS_RULES carries each rule of kRuleTable, in its order");

/// Calls `use(row, wire)` for each rule that COMMS_RULES carries.
template <class Use>
void EachRule(const Use& use) {
  size_t place = 0;
  for (const RuleRow& row : kRuleTable) {
    if (IsOnTheWire(row)) use(row, kWire[place++]);
  }
}

/// Types that hold the same: of a rule, and of its member of comms_rules_t.
template <class Rule, class Field>
constexpr bool kFit = std::is_same_v<Rule, Field> ||
                      (std::is_same_v<Rule, bool> && std::is_same_v<Field, int8_t>) ||
                      (std::is_same_v<Rule, MediaChoice> && std::is_same_v<Field, std::string>);

void ToWire(const MediaChoice& rule, std::string* field) { *field = TextOf(rule); }
void ToWire(bool rule, int8_t* field) { *field = rule ? 1 : 0; }
template <class T>
void ToWire(const T& rule, T* field) {
  *field = rule;
}

void FromWire(const std::string& field, MediaChoice* rule) { *rule = Over(field); }
void FromWire(int8_t field, bool* rule) { *rule = field != 0; }
template <class T>
void FromWire(const T& field, T* rule) {
  *rule = field;
}

/// Calls `copy(rule, field)` with pointers to both members of each rule.
template <class Copy>
void EachMember(const Copy& copy) {
  EachRule([&](const RuleRow& row, const WireRow& wire) {
    std::visit(
        [&]<class R, class F>(R rule, F field) {
          if constexpr (requires(RoutingRules & r, comms_rules_t & m) { r.*rule, m.*field; }) {
            using Rule = std::remove_reference_t<decltype(std::declval<RoutingRules&>().*rule)>;
            using Field = std::remove_reference_t<decltype(std::declval<comms_rules_t&>().*field)>;
            if constexpr (kFit<Rule, Field>) return copy(rule, field);
          }
          SHOAL_CHECK(false, "a rule and its member of comms_rules_t have types that fit");
        },
        row.member, wire.member);
  });
}

}  // namespace

void PutRules(const RoutingRules& rules, comms_rules_t* message) {
  EachMember([&](auto rule, auto field) { ToWire(rules.*rule, &(message->*field)); });
}

RoutingRules RulesOf(const comms_rules_t& message) {
  RoutingRules rules;
  EachMember([&](auto rule, auto field) { FromWire(message.*field, &(rules.*rule)); });
  return rules;
}

std::string ImpossibleRule(const comms_rules_t& message, std::span<const std::string> media) {
  const RoutingRules rules = RulesOf(message);
  std::string impossible;
  EachRule([&](const RuleRow& row, const WireRow& wire) {
    if (!impossible.empty()) return;
    if (row.type == RuleType::kMedia) {
      const auto& text = message.*std::get<std::string comms_rules_t::*>(wire.member);
      for (const std::string& name : Over(text).names) {
        const bool is_known = std::ranges::find(media, name) != media.end();
        if (!is_known) impossible = fmt::format("{} = '{}'", row.rule, text.substr(0, 64));
      }
    } else if (row.type != RuleType::kText) {
      const double value = GetRule(row, rules).number;
      const bool is_possible = row.channel.empty() ? !std::isnan(value) : IsPossible(row, value);
      if (!is_possible) impossible = fmt::format("{} = {}", row.rule, value);
    }
  });
  return impossible;
}

}  // namespace shoal
