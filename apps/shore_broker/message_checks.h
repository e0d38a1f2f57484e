// What makes a report or a message meaningless before any rule is asked.
#pragma once

#include <string>
#include <string_view>

#include "shoal/node_message_t.hpp"
#include "shoal/node_report_t.hpp"

namespace shoal {

/// Returns false where one of the numbers of a report is infinite or not a number.
[[nodiscard]] bool AllNumbersAreFinite(const node_report_t& report);

/// Returns the name, or nothing if it is not one that a vehicle may have: for what is written of
/// it.
[[nodiscard]] std::string LegalOrEmpty(const std::string& name);

/// Returns what makes a message meaningless; empty: nothing.
[[nodiscard]] std::string_view ProblemOf(const node_message_t& message);

}  // namespace shoal
