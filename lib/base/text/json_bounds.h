// Bounds of a text in JSON, looked at before a parser takes memory for it: a parser keeps some 80
// bytes for each value, and "[[[[" or "{},{}," are values in little text.
//
//   const std::string problem = WhyNotWithin(text, {.depth = 8, .num_values = 1'000'000});
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace shoal {

struct JsonBounds {
  size_t depth = 0;       ///< Of lists and objects within each other.
  size_t num_values = 0;  ///< Numbers, texts, words, lists, objects and keys.
};

/// Returns what is beyond the bounds, with its line; empty: nothing. Whether it is JSON is for the
/// parser to find out.
[[nodiscard]] std::string WhyNotWithin(std::string_view text, const JsonBounds& bounds);

}  // namespace shoal
