// Blanks around and between words.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace shoal {

/// Blank, tab, line feed, carriage return, vertical tab and form feed.
inline constexpr std::string_view kBlanks = " \t\r\n\v\f";

/// Returns `text` without blanks at its ends; it points into `text`.
[[nodiscard]] constexpr std::string_view Trimmed(std::string_view text) {
  const size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// Returns the parts of `text` between separators, trimmed; one empty part of an empty text. They
/// point into `text`.
[[nodiscard]] inline std::vector<std::string_view> TrimmedParts(std::string_view text,
                                                                char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const size_t end = std::min(text.find(separator), text.size());
    parts.push_back(Trimmed(text.substr(0, end)));
    if (end == text.size()) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace shoal
