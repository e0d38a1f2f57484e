#include "lib/base/text/json_bounds.h"

#include <algorithm>

namespace shoal {

std::string WhyNotWithin(std::string_view text, const JsonBounds& bounds) {
  size_t depth = 0;
  size_t num_values = 1;
  bool is_quoted = false;
  const auto problem = [&](size_t at, const std::string& what) {
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    return "line " + std::to_string(line) + ": " + what;
  };
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_quoted) {
      if (c == '\\') ++i;
      if (c == '"') is_quoted = false;
      continue;
    }
    if (c == '"') is_quoted = true;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (c == '[' || c == '{') ++depth;
    // A value follows each of these, or precedes it.
    if (c == '[' || c == '{' || c == ',' || c == ':') ++num_values;
    if (depth > bounds.depth) {
      return problem(i, "nested more than " + std::to_string(bounds.depth) + " deep");
    }
    if (num_values > bounds.num_values) {
      return problem(i, "more than " + std::to_string(bounds.num_values) + " values");
    }
  }
  return "";
}

}  // namespace shoal
