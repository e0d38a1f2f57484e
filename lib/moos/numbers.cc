#include "lib/moos/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "lib/moos/fields.h"

namespace shoal {
namespace {

constexpr uint64_t kMicro = 1'000'000;

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// Returns value * 10 + digit; nothing beyond 64 bits.
std::optional<uint64_t> Append(uint64_t value, uint64_t digit) {
  constexpr uint64_t kMax = std::numeric_limits<uint64_t>::max();
  if (value > (kMax - digit) / 10) return std::nullopt;
  return value * 10 + digit;
}

/// Returns "123.456" as microseconds; nothing where there are other characters than digits and one
/// point, or where they do not fit.
std::optional<uint64_t> ParseDecimalMicros(std::string_view digits) {
  uint64_t micros = 0;
  int num_decimals = -1;  // Before the point.
  bool any = false;
  for (const char c : digits) {
    if (c == '.' && num_decimals < 0) {
      num_decimals = 0;
      continue;
    }
    if (!IsDigit(c)) return std::nullopt;
    any = true;
    const auto digit = static_cast<uint64_t>(c - '0');
    if (num_decimals < 6) {
      const auto longer = Append(micros, digit);
      if (!longer) return std::nullopt;
      micros = *longer;
    } else if (num_decimals == 6 && digit >= 5) {
      if (micros == std::numeric_limits<uint64_t>::max()) return std::nullopt;
      ++micros;
    }
    if (num_decimals >= 0 && num_decimals < 7) ++num_decimals;
  }
  for (int i = std::max(num_decimals, 0); i < 6; ++i) {
    const auto longer = Append(micros, 0);
    if (!longer) return std::nullopt;
    micros = *longer;
  }
  if (!any) return std::nullopt;
  return micros;
}

}  // namespace

std::optional<double> ParseNumber(std::string_view text) {
  std::string_view digits = Trimmed(text);
  if (digits.starts_with('+')) {
    digits.remove_prefix(1);
    if (digits.starts_with('-')) return std::nullopt;
  }
  double number = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number);
  if (error != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::string NumberText(double number) {
  // JSON would take -0 for an integer, which has no sign of its own.
  if (number == 0 && std::signbit(number)) return "-0.0";
  return fmt::format("{}", number);
}

std::optional<int64_t> ParseSeconds(std::string_view text) {
  std::string_view digits = Trimmed(text);
  const bool is_negative = digits.starts_with('-');
  if (is_negative || digits.starts_with('+')) digits.remove_prefix(1);
  constexpr auto kMax = static_cast<uint64_t>(std::numeric_limits<int64_t>::max());
  if (digits.find_first_of("eE") != std::string_view::npos) {
    const auto seconds = ParseNumber(text);
    if (!seconds || std::abs(*seconds) > 9e12) return std::nullopt;
    return std::llround(*seconds * 1e6);
  }
  const auto micros = ParseDecimalMicros(digits);
  if (!micros || *micros > kMax + (is_negative ? 1 : 0)) return std::nullopt;
  return static_cast<int64_t>(is_negative ? 0 - *micros : *micros);
}

std::string SecondsText(int64_t utime) {
  const auto bits = static_cast<uint64_t>(utime);
  const uint64_t micros = utime < 0 ? 0 - bits : bits;
  std::string text = fmt::format("{}{}", utime < 0 ? "-" : "", micros / kMicro);
  if (micros % kMicro == 0) return text;
  text += fmt::format(".{:06}", micros % kMicro);
  return text.substr(0, text.find_last_not_of('0') + 1);
}

}  // namespace shoal
