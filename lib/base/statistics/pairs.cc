#include "lib/base/statistics/pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/base/check/check.h"
#include "lib/base/statistics/distributions.h"
#include "lib/base/statistics/mean_interval.h"

namespace shoal {

namespace {

/// Returns Welch's interval of b's mean less a's, with Satterthwaite's degrees of freedom.
Interval WelchInterval(const Moments& a, const Moments& b, double confidence) {
  if (a.num < 2 || b.num < 2) return {};
  const double difference = b.mean - a.mean;
  const auto variance = [](const Moments& of) {
    return of.standard_deviation * of.standard_deviation / static_cast<double>(of.num);
  };
  const double of_a = variance(a);
  const double of_b = variance(b);
  const double sum = of_a + of_b;
  if (!std::isfinite(difference) || !std::isfinite(sum)) return {};
  if (sum == 0) return {difference, difference};
  // As shares of the sum: squares of very small variances would be 0.
  const double part_a = of_a / sum;
  const double part_b = of_b / sum;
  const double degrees = 1 / (part_a * part_a / static_cast<double>(a.num - 1) +
                              part_b * part_b / static_cast<double>(b.num - 1));
  const double half_width = StudentCritical(degrees, confidence) * std::sqrt(sum);
  return {difference - half_width, difference + half_width};
}

double TwoSidedP(const Moments& differences) {
  if (differences.num < 2 || !std::isfinite(differences.mean) ||
      !std::isfinite(differences.standard_deviation)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (differences.mean == 0) return 1;
  if (differences.standard_deviation == 0) return 0;
  const auto n = static_cast<double>(differences.num);
  return StudentTwoSidedTail(n - 1,
                             differences.mean / (differences.standard_deviation / std::sqrt(n)));
}

}  // namespace

double McNemarExact(int64_t only_a, int64_t only_b) {
  SHOAL_CHECK(only_a >= 0 && only_b >= 0, "a number of pairs is not negative");
  if (only_a == only_b) return 1;
  return std::min(1.0, 2 * BinomialCumulative(std::min(only_a, only_b), only_a + only_b, 0.5));
}

PairedMeans ComparePairs(std::span<const double> a, std::span<const double> b, double confidence) {
  SHOAL_CHECK(a.size() == b.size(), "each value has its partner");
  PairedMeans result;
  std::vector<double> differences;
  differences.reserve(a.size());
  for (size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) ++result.num_equal;
    // Not b - a where both are the same infinity.
    differences.push_back(a[i] == b[i] ? 0 : b[i] - a[i]);
  }
  const Moments of_a = MomentsOf(a);
  const Moments of_b = MomentsOf(b);
  const Moments of_differences = MomentsOf(differences);
  result.num_pairs = of_differences.num;
  result.mean_a = of_a.mean;
  result.mean_b = of_b.mean;
  result.difference = of_differences.mean;
  result.interval = MeanInterval(of_differences, confidence);
  result.p = TwoSidedP(of_differences);
  result.unpaired = WelchInterval(of_a, of_b, confidence);
  result.narrowing = result.unpaired.half_width() / result.interval.half_width();
  return result;
}

}  // namespace shoal
