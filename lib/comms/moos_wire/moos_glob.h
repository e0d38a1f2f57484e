// Patterns of names as MOOS has them: '*' stands for any characters, '?' for one.
#pragma once

#include <cstddef>
#include <string_view>

namespace shoal {

/// Returns true if `text` as a whole fits `pattern`. Case counts. Takes at most the product of both
/// lengths in time, and no memory.
[[nodiscard]] constexpr bool MatchesMoosGlob(std::string_view pattern, std::string_view text) {
  size_t p = 0;
  size_t t = 0;
  size_t star = std::string_view::npos;  // The last '*' that was passed ...
  size_t resume = 0;  // ... and where the text goes on behind what it stands for.
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace shoal
