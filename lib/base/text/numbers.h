// Numbers as files, command lines and messages write them, whatever the locale.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace shoal {

/// Returns the number that the whole of `text` is, decimal, with one sign at most: "7", "+0.5",
/// "-1e3". Nothing for all other texts, with blanks among them, for numbers beyond T, for NaN and
/// for infinity. Blanks around it are the caller's to trim (blanks.h).
template <class T>
[[nodiscard]] std::optional<T> ReadNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  T number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(number)) return std::nullopt;
  }
  return number;
}

/// Returns the finite number that `text` is, blanks around it left out, or nothing.
[[nodiscard]] std::optional<double> NumberIn(std::string_view text);

/// Returns the shortest text that ReadNumber reads as the same number; "nan", "inf" or "-inf" for
/// what is not finite.
[[nodiscard]] std::string ShortestText(double number);

/// Returns 7 in three digits as "007"; a number that needs more takes more.
[[nodiscard]] std::string ZeroPadded(int64_t number, int width);

}  // namespace shoal
