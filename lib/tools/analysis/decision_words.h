// A helm's decision in words: what it chose, what each behavior wanted, and what it gave up.
#pragma once

#include <string>

#include "shoal/helm_decision_t.hpp"

namespace shoal {

/// Returns several lines: the decision, one line for each behavior, and the reason in a sentence.
/// Text of the message is made printable.
[[nodiscard]] std::string DecisionWords(const helm_decision_t& decision);

/// Returns one line: time, course and speed, and the behavior that decided.
[[nodiscard]] std::string DecisionLine(const helm_decision_t& decision);

}  // namespace shoal
