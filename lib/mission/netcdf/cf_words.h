// Words in attributes of NetCDF files.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/text/blanks.h"

namespace shoal {

/// Returns the words of a text, which blanks separate.
inline std::vector<std::string_view> WordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  for (text = Trimmed(text); !text.empty(); text = Trimmed(text)) {
    const size_t end = std::min(text.find_first_of(" \t\n\r"), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return words;
}

/// Returns a name as it may be in a message: short, and printable.
inline std::string PrintableName(std::string_view name) {
  std::string printable(name.substr(0, 60));
  for (char& c : printable) {
    if (c < ' ' || c > '~') c = '?';
  }
  return printable;
}

}  // namespace shoal
