// Pieces of the text of a .bhv file.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

/// Returns the text without blanks and double quotes around it.
[[nodiscard]] std::string_view WithoutQuotes(std::string_view text);

/// Returns the parts between separators, without blanks at their ends and without empty ones.
[[nodiscard]] std::vector<std::string> PartsOf(std::string_view text, std::string_view separators);

/// Adds the words that may be variables.
void CollectVariables(std::string_view text, std::set<std::string, std::less<>>* variables);

/// Returns a condition as shoal has it: in MOOS-IvP a comma stands for '='.
[[nodiscard]] std::string ConditionText(std::string_view text);

/// Returns a list of texts as TOML.
[[nodiscard]] std::string TomlTexts(const std::vector<std::string>& texts);

/// Returns numbers as TOML: of "1, 1.5 : 2" each, of "5,60 : 10" as pairs, where 0 stands for a
/// second that is left out.
[[nodiscard]] Result<std::string> TomlNumbers(std::string_view text, bool is_pairs);

}  // namespace shoal
