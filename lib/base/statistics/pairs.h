// Comparisons of two things that were tried under the same conditions, pair by pair.
#pragma once

#include <cstdint>
#include <span>

#include "lib/base/statistics/interval.h"

namespace shoal {

/// Returns the two-sided p of the exact McNemar test (McNemar 1947; exact: Cochran 1950): of pairs
/// in which one alone succeeded, `only_a` and `only_b` are a binomial draw at 1/2 where neither is
/// better. 1 without such pairs. @pre neither is negative
[[nodiscard]] double McNemarExact(int64_t only_a, int64_t only_b);

/// The mean of b - a.
struct PairedMeans {
  int64_t num_pairs = 0;
  int64_t num_equal = 0;  ///< The difference is exactly 0.
  double mean_a = 0;
  double mean_b = 0;
  double difference = 0;  ///< NaN without pairs, as the means are.
  Interval interval;      ///< Student's t of the differences.
  double p = 1;           ///< Two-sided, that the mean difference is 0; NaN below two pairs.
  Interval unpaired;      ///< Welch's (1947), as if the pairs were not known.
  double narrowing = 1;   ///< Width of `unpaired` over that of `interval`: how many times less.
                          ///< Infinite where all differences are equal; NaN where both are 0.
};

/// Returns the paired t test (Student 1908) and what the pairs gained. @pre a.size() == b.size()
[[nodiscard]] PairedMeans ComparePairs(std::span<const double> a, std::span<const double> b,
                                       double confidence);

}  // namespace shoal
