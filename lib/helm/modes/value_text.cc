#include "lib/helm/modes/value_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace shoal {
namespace {

constexpr size_t kLongestName = 64;

bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '.' || c == '-';
}

}  // namespace

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n\v\f";
  const size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::optional<double> NumberIn(std::string_view text) {
  text = Trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (text.empty() || error != std::errc() || rest != end || !std::isfinite(number)) {
    return std::nullopt;
  }
  return number;
}

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
  const double number = std::get<double>(value);
  std::array<char, 32> buffer = {};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return {buffer.data(), end};
}

std::string VariableNameProblem(std::string_view name) {
  if (name.empty()) return "the name of a variable is missing";
  if (name.size() > kLongestName) return "the name of a variable has more than 64 characters";
  if (!std::all_of(name.begin(), name.end(), IsNameCharacter)) {
    return "'" + std::string(name) +
           "' is no name of a variable: letters, digits and _ . - are, as in DEPLOY";
  }
  return {};
}

}  // namespace shoal
