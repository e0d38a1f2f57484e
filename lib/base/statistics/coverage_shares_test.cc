// Intervals of shares: coverage by simulated campaigns, and exactly by summing the binomial.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/base/random/discrete.h"
#include "lib/base/statistics/coverage_testing.h"
#include "lib/base/statistics/share_interval.h"

namespace shoal {

namespace {

using IntervalOfShare = Interval (*)(int64_t successes, int64_t trials, double confidence);

std::vector<Interval> IntervalsOf(IntervalOfShare function, int64_t trials, double confidence) {
  std::vector<Interval> intervals;
  for (int64_t k = 0; k <= trials; ++k) intervals.push_back(function(k, trials, confidence));
  return intervals;
}

/// Returns the lowest coverage over 2,000 probabilities.
double LowestExactCoverage(IntervalOfShare function, int trials, double confidence) {
  const std::vector<Interval> intervals = IntervalsOf(function, trials, confidence);
  double lowest = 1;
  for (int i = 1; i < 2000; ++i) {
    const double p = i / 2000.0;
    double coverage = 0;
    for (int k = 0; k <= trials; ++k) {
      if (!intervals[static_cast<size_t>(k)].Contains(p)) continue;
      coverage +=
          std::exp(std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) -
                   std::lgamma(trials - k + 1.0) + k * std::log(p) + (trials - k) * std::log1p(-p));
    }
    lowest = std::min(lowest, coverage);
  }
  return lowest;
}

}  // namespace

class ShareCoverage : public ::testing::TestWithParam<int> {};

TEST_P(ShareCoverage, IsAtLeastTheConfidence) {
  const int trials = GetParam();
  for (const double confidence : {0.95, 0.99}) {
    const auto intervals = IntervalsOf(ShareInterval, trials, confidence);
    for (const double p : {0.01, 0.1, 0.5, 0.99}) {
      const double coverage = MeasureCoverage(
          fmt::format("share_{}_n{}_p{}", confidence, trials, p), [&](Stream* stream) {
            return intervals[static_cast<size_t>(DrawBinomial(trials, p, stream))].Contains(p);
          });
      EXPECT_GE(coverage, LeastCoverage(confidence)) << confidence << " " << trials << " " << p;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Trials, ShareCoverage, ::testing::Values(20, 200, 1000));

TEST(ShareCoverageExactly, IsNeverBelowTheConfidence) {
  for (const int trials : {1, 2, 5, 20, 100}) {
    for (const double confidence : {0.8, 0.95, 0.99, 0.9999}) {
      EXPECT_GE(LowestExactCoverage(ShareInterval, trials, confidence), confidence - 1e-12)
          << trials << " " << confidence;
    }
  }
}

TEST(ShareCoverageExactly, OfWilsonAloneIsLessAtHighConfidences) {
  EXPECT_LT(LowestExactCoverage(WilsonInterval, 20, 0.99), 0.975);
  EXPECT_GE(LowestExactCoverage(WilsonInterval, 20, 0.95), 0.95);
}

}  // namespace shoal
