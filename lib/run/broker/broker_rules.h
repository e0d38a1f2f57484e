// The rules in force at a broker, and COMMS_RULES, which states them: a list of keys and values, so
// that a rule can come or go while the type of the message stays (docs/inside/wire.md).
//
//   if (const auto rules = ReadBrokerRules(event.data)) ...   // Of any version's log.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/geodesy/local_frame.h"
#include "lib/comms/routing/rules.h"
#include "lib/sea/acoustics/channel_plan.h"
#include "shoal/broker_rules_t.hpp"

namespace shoal {

struct BrokerRules {
  int64_t utime = 0;
  bool is_start = false;  ///< The broker has begun to work: it knows no vehicle.
  int64_t seed = 1;       ///< The mission's.
  int64_t tick_us = 100'000;
  GeoPoint origin = {};
  std::vector<AcousticNode> vehicles = {};  ///< The mission's, in its order.
  RoutingRules rules = {};
  std::vector<std::pair<std::string, LinkFactors>> factors = {};  ///< Others than 1.
  std::string media = {};       ///< Networks and media, as a mission file has them.
  std::string arithmetic = {};  ///< ArithmeticId() of the broker; empty in logs of 0.1 and 0.2.

  // What a message shows beyond that; empty in the rules that a broker publishes.
  std::vector<broker_rule_t> unknown = {};  ///< Rules that this build does not know.
  std::vector<std::string> lacking = {};    ///< Keys that the message lacks: they have defaults.
  std::vector<std::string> wrong = {};      ///< Such as "groups is a text, not a flag".
};

/// Returns each rule of kRuleTable with its value, and of each vehicle of `factors` its own.
[[nodiscard]] broker_rules_t ToMessage(const BrokerRules& rules);

/// Returns the rules of a message, whatever their values.
[[nodiscard]] BrokerRules FromMessage(const broker_rules_t& message);

/// Returns the rules of an encoded broker_rules_t or, as logs of 0.1 and 0.2 have it,
/// comms_rules_t; nothing for other bytes. The fingerprint decides.
[[nodiscard]] std::optional<BrokerRules> ReadBrokerRules(std::span<const uint8_t> data);

/// Returns the first rule with a value that is impossible: "comms_range = nan"; empty: all are
/// possible. `media`: the names of those that exist.
[[nodiscard]] std::string ImpossibleRule(const RoutingRules& rules,
                                         std::span<const std::string> media);

/// Returns a line for each rule that the message has and this build does not know, and for each
/// that the message lacks.
[[nodiscard]] std::vector<std::string> StrangeRules(const BrokerRules& rules);

}  // namespace shoal
