// RoutingRules as COMMS_RULES carries them.
#pragma once

#include <span>
#include <string>

#include "lib/comms/routing/rules.h"
#include "shoal/comms_rules_t.hpp"

namespace shoal {

/// Writes each rule into its member of `message`; leaves all other members as they are.
void PutRules(const RoutingRules& rules, comms_rules_t* message);

/// Returns the rules of a message, whatever their values.
[[nodiscard]] RoutingRules RulesOf(const comms_rules_t& message);

/// Returns the first rule of `message` with a value that is impossible: "comms_range = nan"; empty:
/// all are possible. `media`: the names of those that exist.
[[nodiscard]] std::string ImpossibleRule(const comms_rules_t& message,
                                         std::span<const std::string> media);

}  // namespace shoal
