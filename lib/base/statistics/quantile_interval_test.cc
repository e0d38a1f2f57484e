#include "lib/base/statistics/quantile_interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace shoal {

namespace {

/// Returns 1, 2, ... `num`: the value is the rank.
std::vector<double> RanksUpTo(int num) {
  std::vector<double> ranks(static_cast<size_t>(num));
  std::iota(ranks.begin(), ranks.end(), 1.0);
  return ranks;
}

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

}  // namespace

TEST(SampleQuantile, IsThatOfNumpy) {
  const std::vector<double> values = {1, 2, 4, 8};
  EXPECT_DOUBLE_EQ(SampleQuantile(values, 0), 1);
  EXPECT_DOUBLE_EQ(SampleQuantile(values, 0.5), 3);
  EXPECT_DOUBLE_EQ(SampleQuantile(values, 0.95), 7.4);
  EXPECT_DOUBLE_EQ(SampleQuantile(values, 1), 8);
  EXPECT_TRUE(std::isnan(SampleQuantile({}, 0.5)));
}

TEST(SampleQuantile, DoesNotOverflow) {
  const std::vector<double> values = {-1.7e308, 1.7e308};
  EXPECT_EQ(SampleQuantile(values, 0.5), 0);
}

// Conover 1999, Practical Nonparametric Statistics, table of the sign test: the ranks that bound
// the median with at least 95 %.
TEST(QuantileInterval, OfTheMedianHasThePublishedRanks) {
  EXPECT_EQ(QuantileInterval(RanksUpTo(10), 0.5, 0.95), (Interval{2, 9}));
  EXPECT_EQ(QuantileInterval(RanksUpTo(20), 0.5, 0.95), (Interval{6, 15}));
  EXPECT_EQ(QuantileInterval(RanksUpTo(6), 0.5, 0.95), (Interval{1, 6}));
}

TEST(QuantileInterval, HasNoEndsWhereTheSampleIsTooSmall) {
  EXPECT_EQ(QuantileInterval(RanksUpTo(5), 0.5, 0.95), Interval());
  EXPECT_EQ(QuantileInterval({}, 0.5, 0.95), Interval());
  // 0.95^71 > 0.025 > 0.95^72.
  EXPECT_EQ(QuantileInterval(RanksUpTo(71), 0.95, 0.95).high, kUnbounded);
  EXPECT_EQ(QuantileInterval(RanksUpTo(72), 0.95, 0.95).high, 72);
}

TEST(QuantileInterval, IsAPointWhereAllAreEqual) {
  EXPECT_EQ(QuantileInterval(std::vector<double>(100, 7.0), 0.05, 0.95), (Interval{7, 7}));
}

TEST(QuantileInterval, HasNoEndsAtTheConfidenceOne) {
  EXPECT_EQ(QuantileInterval(RanksUpTo(1000), 0.5, 1), Interval());
}

}  // namespace shoal
