// Intervals of means and of paired differences: coverage by simulated campaigns.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/base/statistics/coverage_testing.h"
#include "lib/base/statistics/mean_interval.h"
#include "lib/base/statistics/pairs.h"

namespace shoal {

namespace {

double Exponential(Stream* stream) { return -std::log1p(-stream->Uniform()); }

template <class Draw>
double MeanCoverage(const std::string& name, size_t num, double truth, Draw draw) {
  std::vector<double> values(num);
  return MeasureCoverage(name, [&](Stream* stream) {
    for (double& value : values) value = draw(stream);
    return MeanInterval(MomentsOf(values), 0.95).Contains(truth);
  });
}

}  // namespace

class MeanCoverageOf : public ::testing::TestWithParam<size_t> {};

TEST_P(MeanCoverageOf, NormalValuesIsTheConfidence) {
  const double coverage = MeanCoverage(fmt::format("normal_n{}", GetParam()), GetParam(), 7,
                                       [](Stream* stream) { return 7 + 3 * stream->Normal(); });
  EXPECT_GE(coverage, LeastCoverage(0.95));
  EXPECT_LE(coverage, 0.95 + (0.95 - LeastCoverage(0.95)));
}

INSTANTIATE_TEST_SUITE_P(Trials, MeanCoverageOf, ::testing::Values(2, 20, 200));

// The t interval is exact for normal values alone; of what is skewed it covers less in few trials.
TEST(MeanCoverageOfSkewedValues, IsTooSmallInTwentyTrials) {
  const double coverage = MeanCoverage("exponential_n20", 20, 1, Exponential);
  EXPECT_LT(coverage, LeastCoverage(0.95));
  EXPECT_GT(coverage, 0.90);
}

TEST(MeanCoverageOfSkewedValues, IsWithinOnePercentInTwoHundredTrials) {
  EXPECT_GT(MeanCoverage("exponential_n200", 200, 1, Exponential), 0.94);
}

TEST(MeanCoverageOfSkewedValues, IsTheConfidenceInAThousandTrials) {
  EXPECT_GE(MeanCoverage("exponential_n1000", 1000, 1, Exponential), LeastCoverage(0.95));
}

TEST(PairedCoverage, IsTheConfidenceAndPairingNarrows) {
  constexpr size_t kPairs = 30;
  std::vector<double> a(kPairs);
  std::vector<double> b(kPairs);
  double sum_of_narrowing = 0;
  int num_unpaired_covers = 0;
  const double coverage = MeasureCoverage("paired_n30", [&](Stream* stream) {
    for (size_t i = 0; i < kPairs; ++i) {
      const double sea = 2 * stream->Normal();
      a[i] = 10 + sea + stream->Normal();
      b[i] = 10.5 + sea + stream->Normal();
    }
    const PairedMeans compared = ComparePairs(a, b, 0.95);
    sum_of_narrowing += compared.narrowing;
    if (compared.unpaired.Contains(0.5)) ++num_unpaired_covers;
    return compared.interval.Contains(0.5);
  });
  EXPECT_GE(coverage, LeastCoverage(0.95));
  // Variances 2 * (4 + 1) unpaired and 2 paired: the widths are as sqrt(5), less what Student's t
  // has for half the degrees of freedom.
  const double narrowing = sum_of_narrowing / kSimulatedCampaigns;
  RecordProperty("narrowing", std::to_string(narrowing));
  EXPECT_NEAR(narrowing, std::sqrt(5) * 2.0017 / 2.0452, 0.05);
  EXPECT_GT(num_unpaired_covers, 9'990) << "an interval that knows no pairs is far too wide";
}

}  // namespace shoal
