#include "lib/helm/modes/value_text.h"

#include <algorithm>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"

namespace shoal {
namespace {

constexpr size_t kLongestName = 64;

bool IsOfAName(char c) { return IsNameCharacter(c) || c == '.' || c == '-'; }

}  // namespace

VariableValue ValueIn(std::string_view text) {
  text = Trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    return std::string(text.substr(1, text.size() - 2));
  }
  const std::optional<double> number = NumberIn(text);
  if (number) return *number;
  return std::string(text);
}

std::string TextOf(const VariableValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return ShortestText(std::get<double>(value));
}

std::string VariableNameProblem(std::string_view name) {
  if (name.empty()) return "the name of a variable is missing";
  if (name.size() > kLongestName) return "the name of a variable has more than 64 characters";
  if (!std::all_of(name.begin(), name.end(), IsOfAName)) {
    return "'" + std::string(name) +
           "' is not a name of a variable: letters, digits and _ . - are, as in DEPLOY";
  }
  return {};
}

}  // namespace shoal
