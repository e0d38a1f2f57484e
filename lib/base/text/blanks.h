// Blanks around and between words.
#pragma once

#include <string_view>

namespace shoal {

/// Blank, tab, line feed, carriage return, vertical tab and form feed.
inline constexpr std::string_view kBlanks = " \t\r\n\v\f";

/// Returns `text` without blanks at its ends; it points into `text`.
[[nodiscard]] constexpr std::string_view Trimmed(std::string_view text) {
  const size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

}  // namespace shoal
