// Letters of ASCII, whatever the locale; <cctype> asks for it.
#pragma once

#include <string>
#include <string_view>

namespace shoal {

constexpr bool IsDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
/// Returns true for letters, digits and '_'.
constexpr bool IsNameCharacter(char c) { return IsLetter(c) || IsDigit(c) || c == '_'; }

constexpr char LowerCase(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
constexpr char UpperCase(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// Return `text` with its letters in one case; all other bytes stay as they are.
[[nodiscard]] std::string LowerCase(std::string_view text);
[[nodiscard]] std::string UpperCase(std::string_view text);

/// Returns true if the texts differ in the case of their letters at most.
[[nodiscard]] bool IsSameWord(std::string_view a, std::string_view b);

}  // namespace shoal
