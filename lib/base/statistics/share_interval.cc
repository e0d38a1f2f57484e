#include "lib/base/statistics/share_interval.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/statistics/distributions.h"

namespace shoal {

Interval WilsonInterval(int64_t successes, int64_t trials, double confidence) {
  SHOAL_CHECK(successes >= 0 && successes <= trials && trials > 0, "a share is of trials");
  const double z = NormalQuantile(1 - (1 - confidence) / 2);
  if (std::isinf(z)) return {0, 1};
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / n;
  const auto root = [&](double sign) {
    const double within = z * z - sign * 2 - 1 / n + 4 * share * (n * (1 - share) + sign);
    return z * std::sqrt(std::max(0.0, within));
  };
  const double middle = 2 * n * share + z * z;
  const double scale = 2 * (n + z * z);
  return {successes == 0 ? 0 : std::max(0.0, (middle - 1 - root(1)) / scale),
          successes == trials ? 1 : std::min(1.0, (middle + 1 + root(-1)) / scale)};
}

Interval ExactShareInterval(int64_t successes, int64_t trials, double confidence) {
  SHOAL_CHECK(successes >= 0 && successes <= trials && trials > 0, "a share is of trials");
  const double tail = (1 - confidence) / 2;
  const auto x = static_cast<double>(successes);
  const auto n = static_cast<double>(trials);
  return {successes == 0 ? 0 : BetaQuantile(x, n - x + 1, tail),
          // By symmetry, as the quantile of 1 - tail would lose a tail that is small.
          successes == trials ? 1 : 1 - BetaQuantile(n - x, x + 1, tail)};
}

Interval ShareInterval(int64_t successes, int64_t trials, double confidence) {
  if (trials == 0) return {0, 1};
  const Interval wilson = WilsonInterval(successes, trials, confidence);
  const Interval exact = ExactShareInterval(successes, trials, confidence);
  return {std::min(wilson.low, exact.low), std::max(wilson.high, exact.high)};
}

double BoundOfNone(int64_t trials, double confidence) {
  SHOAL_CHECK(trials >= 0, "a number of trials is not negative");
  if (trials == 0) return 1;
  return -Expm1(Log1p(-confidence) / static_cast<double>(trials));
}

}  // namespace shoal
