#include "lib/base/statistics/quantile_interval.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lib/base/check/check.h"
#include "lib/base/statistics/distributions.h"

namespace shoal {

namespace {

/// Returns the greatest rank of which the order statistic is above the quantile with a probability
/// of at most `tail`; 0: there is none.
int64_t LowerRank(int64_t num, double share, double tail) {
  int64_t low = 0;         // Is one, or none.
  int64_t high = num + 1;  // Is not.
  while (high - low > 1) {
    const int64_t middle = low + (high - low) / 2;
    (BinomialCumulative(middle - 1, num, share) <= tail ? low : high) = middle;
  }
  return low;
}

}  // namespace

double SampleQuantile(std::span<const double> sorted, double share) {
  SHOAL_CHECK(share >= 0 && share <= 1, "a share is in [0, 1]");
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  const double part = place - static_cast<double>(below);
  const double here = sorted[below];
  if (part == 0) return here;
  // Not here + part * (next - here), which overflows where both are huge.
  return here * (1 - part) + sorted[below + 1] * part;
}

Interval QuantileInterval(std::span<const double> sorted, double share, double confidence) {
  SHOAL_CHECK(share > 0 && share < 1, "a quantile is between the least and the greatest value");
  const double tail = (1 - confidence) / 2;
  const auto num = static_cast<int64_t>(sorted.size());
  const int64_t from_below = LowerRank(num, share, tail);
  const int64_t from_above = LowerRank(num, 1 - share, tail);
  Interval interval;
  if (from_below > 0) interval.low = sorted[static_cast<size_t>(from_below - 1)];
  if (from_above > 0) interval.high = sorted[static_cast<size_t>(num - from_above)];
  return interval;
}

}  // namespace shoal
