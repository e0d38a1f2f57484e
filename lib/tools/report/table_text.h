// Numbers as the tables of a campaign show them.
#pragma once

#include <cstdint>
#include <string>

#include "lib/base/statistics/interval.h"

namespace shoal {

/// Returns up to five significant digits in at most ten characters; "-" for NaN.
[[nodiscard]] std::string DigitsText(double value);

/// Returns "12.1 to 12.5", "from 12.1" or "up to 12.5" where an end is infinite, "-" where both
/// are.
[[nodiscard]] std::string IntervalText(const Interval& interval);

/// Returns a share as "95.00 %", small ones with two significant digits: "0.1 %"; "-" for NaN.
[[nodiscard]] std::string PercentText(double share);

/// Returns "93.40 to 96.20 %".
[[nodiscard]] std::string PercentText(const Interval& shares);

/// Returns an upper bound of a share in percent with two significant digits, rounded up: "0.1 %".
[[nodiscard]] std::string BoundText(double share);

/// Returns a p as "0.0123", "< 0.0001"; "-" for NaN.
[[nodiscard]] std::string PText(double p);

/// Returns "1,234,567".
[[nodiscard]] std::string CountText(int64_t count);

/// Returns "1 pair", "2,000 pairs".
[[nodiscard]] std::string CountText(int64_t count, const std::string& thing);

}  // namespace shoal
