// Words in attributes of NetCDF files.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace shoal {

/// Returns a text without the blanks at its ends.
inline std::string_view Trimmed(std::string_view text) {
  const size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
}

/// Returns a text with its letters A to Z as a to z.
inline std::string LowerCaseWord(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

/// Returns a name as it may stand in a message: short, and printable.
inline std::string PrintableName(std::string_view name) {
  std::string printable(name.substr(0, 60));
  for (char& c : printable) {
    if (c < ' ' || c > '~') c = '?';
  }
  return printable;
}

}  // namespace shoal
