// Values of variables as text: "true", "2.5".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/helm/modes/variables.h"

namespace shoal {

/// Returns a number where `text` is one, else the text. Quotes around it are taken off, and then it
/// is text in any case.
[[nodiscard]] VariableValue ValueIn(std::string_view text);

/// Returns the shortest text that reads back as the same value.
[[nodiscard]] std::string TextOf(const VariableValue& value);

/// Returns what is wrong with the name of a variable; empty: nothing. Letters, digits and _ . - are
/// right, at most 64.
[[nodiscard]] std::string VariableNameProblem(std::string_view name);

}  // namespace shoal
