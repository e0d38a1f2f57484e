// A helm's decision in words: what it chose, what each behavior wanted, and what it gave up.
#pragma once

#include <string>

#include "shoal/helm_decision_t.hpp"

namespace shoal {

/// Returns several lines: the decision, one line for each behavior, and the reason in a sentence.
/// Text of the message is made printable.
[[nodiscard]] std::string DecisionWords(const helm_decision_t& decision);

/// Returns one line: time, course and speed, and the behaviors that decided.
[[nodiscard]] std::string DecisionLine(const helm_decision_t& decision);

/// Returns true where two decisions of a vehicle differ in more than small steps: by 5 degrees, 0.2
/// m/s or 0.5 m of depth, in the mode, in what stops the vessel, in which behavior gave up
/// most, or in a role.
[[nodiscard]] bool IsChange(const helm_decision_t& next, const helm_decision_t& last);

}  // namespace shoal
