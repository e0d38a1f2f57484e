// Intervals of quantiles: coverage by simulated campaigns, beside that of the plain bootstrap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "lib/base/statistics/coverage_testing.h"
#include "lib/base/statistics/quantile_interval.h"

namespace shoal {

namespace {

std::vector<double> SortedExponentials(size_t num, Stream* stream) {
  std::vector<double> values(num);
  for (double& value : values) value = -std::log1p(-stream->Uniform());
  std::sort(values.begin(), values.end());
  return values;
}

double ExponentialQuantile(double share) { return -std::log1p(-share); }

/// The percentile bootstrap (Efron 1979) as it is mostly done.
Interval BootstrapInterval(const std::vector<double>& sorted, double share, double confidence,
                           Stream* stream) {
  constexpr int kResamples = 200;
  std::vector<double> quantiles;
  std::vector<double> resample(sorted.size());
  for (int i = 0; i < kResamples; ++i) {
    for (double& value : resample) value = sorted[stream->UniformInt(sorted.size())];
    std::sort(resample.begin(), resample.end());
    quantiles.push_back(SampleQuantile(resample, share));
  }
  std::sort(quantiles.begin(), quantiles.end());
  return {SampleQuantile(quantiles, (1 - confidence) / 2),
          SampleQuantile(quantiles, 1 - (1 - confidence) / 2)};
}

}  // namespace

class QuantileCoverage : public ::testing::TestWithParam<std::tuple<size_t, double>> {};

TEST_P(QuantileCoverage, IsAtLeastTheConfidence) {
  const auto [num, share] = GetParam();
  const std::string name = fmt::format("quantile{}_n{}", share, num);
  const double coverage = MeasureCoverage(name, [&, n = num, at = share](Stream* stream) {
    return QuantileInterval(SortedExponentials(n, stream), at, 0.95)
        .Contains(ExponentialQuantile(at));
  });
  EXPECT_GE(coverage, LeastCoverage(0.95));
}

INSTANTIATE_TEST_SUITE_P(Trials, QuantileCoverage,
                         ::testing::Combine(::testing::Values(5, 20, 200),
                                            ::testing::Values(0.05, 0.5, 0.95)));

TEST(QuantileCoverageOfAThousand, IsAtLeastTheConfidence) {
  std::vector<double> values(1000);
  const double coverage = MeasureCoverage("quantile0.95_n1000", [&](Stream* stream) {
    for (double& value : values) value = stream->Uniform();
    std::sort(values.begin(), values.end());
    return QuantileInterval(values, 0.95, 0.95).Contains(0.95);
  });
  EXPECT_GE(coverage, LeastCoverage(0.95));
}

// Why reports do not use it.
TEST(PlainBootstrap, CoversAHighQuantileTooSeldom) {
  int num_covered = 0;
  constexpr int kCampaigns = 1000;
  for (int campaign = 0; campaign < kCampaigns; ++campaign) {
    Stream stream(18, "plain bootstrap", campaign);
    const auto values = SortedExponentials(20, &stream);
    if (BootstrapInterval(values, 0.95, 0.95, &stream).Contains(ExponentialQuantile(0.95))) {
      ++num_covered;
    }
  }
  RecordProperty("bootstrap0.95_n20", std::to_string(num_covered));
  EXPECT_LT(num_covered, 850);
}

}  // namespace shoal
