// COMMS_RULES as logs of 0.1 and 0.2 hold it: a type with a member for each rule.
#pragma once

#include "shoal/broker_rules_t.hpp"
#include "shoal/comms_rules_t.hpp"

namespace shoal {

/// Returns the same rules as a list of keys and values.
[[nodiscard]] broker_rules_t AsBrokerRules(const comms_rules_t& old);

}  // namespace shoal
