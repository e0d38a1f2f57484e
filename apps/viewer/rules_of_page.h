// The broker says COMMS_RULES when it starts and when a rule changes; a viewer that comes later has
// missed it. To ask for the controls (UNC_CONTROLS_REQ) would be to speak to participants, and the
// run would not be reproducible any more. The broker's status page shows the rules too, and asking
// for it is outside stepping.
#pragma once

#include <optional>
#include <string_view>

#include "shoal/comms_rules_t.hpp"

namespace shoal {

/// Returns the rules that the "Configuration:" of shore_broker's page shows: range, critical range,
/// stale time, drop percentage and the factors of vehicles; nothing where one of the rules is not
/// found. All else is as by default. `text` may be anything.
[[nodiscard]] std::optional<comms_rules_t> RulesOfPage(std::string_view text);

}  // namespace shoal
