#include "lib/tools/report/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"

namespace shoal {

namespace {

std::string PercentDigits(double share) {
  const double percent = 100 * share;
  const double rest = std::min(percent, 100 - percent);
  // At both ends more digits: 99.9987 % is not 100 %.
  if (percent <= 0 || percent >= 100 || rest >= 0.1) return fmt::format("{:.2f}", percent);
  if (rest < 1e-6) return fmt::format("{:.6f}", percent);
  return fmt::format("{:.{}f}", percent, 1 - static_cast<int>(std::floor(Log10(rest) + 1e-9)));
}

}  // namespace

std::string DigitsText(double value) {
  if (std::isnan(value)) return "-";
  const std::string text = fmt::format("{:.5g}", value);
  return text.size() <= 10 ? text : fmt::format("{:.2e}", value);
}

std::string IntervalText(const Interval& interval) {
  const bool has_low = std::isfinite(interval.low);
  const bool has_high = std::isfinite(interval.high);
  if (has_low && has_high) {
    return fmt::format("{} to {}", DigitsText(interval.low), DigitsText(interval.high));
  }
  if (has_low) return "from " + DigitsText(interval.low);
  return has_high ? "up to " + DigitsText(interval.high) : "-";
}

std::string PercentText(double share) {
  return std::isnan(share) ? "-" : PercentDigits(share) + " %";
}

std::string PercentText(const Interval& shares) {
  return fmt::format("{} to {} %", PercentDigits(shares.low), PercentDigits(shares.high));
}

std::string BoundText(double share) {
  const double percent = 100 * share;
  if (!(percent > 0)) return "0 %";
  const double unit = Pow(10, std::floor(Log10(percent)) - 1);
  const double bound = std::min(100.0, std::ceil(percent / unit) * unit);
  return bound < 100 ? fmt::format("{:.2g} %", bound) : "100 %";
}

std::string PText(double p) {
  if (std::isnan(p)) return "-";
  return p < 1e-4 ? "< 0.0001" : fmt::format("{:.4f}", p);
}

std::string CountText(int64_t count) {
  std::string digits = std::to_string(count);
  for (size_t i = digits.size(); i > (count < 0 ? 4U : 3U); i -= 3) digits.insert(i - 3, ",");
  return digits;
}

std::string CountText(int64_t count, const std::string& thing) {
  return fmt::format("{} {}{}", CountText(count), thing, count == 1 ? "" : "s");
}

}  // namespace shoal
