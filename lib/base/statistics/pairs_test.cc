#include "lib/base/statistics/pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace shoal {

TEST(McNemarExact, IsTheTailsOfABinomialAtOneHalf) {
  EXPECT_NEAR(McNemarExact(0, 5), 2 / 32.0, 1e-15);
  EXPECT_NEAR(McNemarExact(1, 9), 2 * 11 / 1024.0, 1e-15);
  EXPECT_NEAR(McNemarExact(9, 1), 2 * 11 / 1024.0, 1e-15);
}

TEST(McNemarExact, FindsNothingWhereNothingDiffers) {
  EXPECT_EQ(McNemarExact(0, 0), 1);
  EXPECT_EQ(McNemarExact(7, 7), 1);
  EXPECT_EQ(McNemarExact(1, 0), 1);
}

// Student 1908, the hours of sleep by two drugs: t = 4.0621 at 9 degrees, p = 0.002833 paired;
// Welch's interval -0.2055 to 3.3655.
TEST(ComparePairs, FindsWhatStudentFound) {
  const std::vector<double> a = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
  const std::vector<double> b = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
  const PairedMeans compared = ComparePairs(a, b, 0.95);
  EXPECT_EQ(compared.num_pairs, 10);
  EXPECT_EQ(compared.num_equal, 1);
  EXPECT_NEAR(compared.difference, 1.58, 1e-12);
  EXPECT_NEAR(compared.p, 0.00283289, 1e-8);
  EXPECT_NEAR(compared.interval.low, 0.7001142, 1e-6);
  EXPECT_NEAR(compared.interval.high, 2.4598858, 1e-6);
  EXPECT_NEAR(compared.unpaired.low, -0.2054832, 1e-6);
  EXPECT_NEAR(compared.unpaired.high, 3.3654832, 1e-6);
  EXPECT_NEAR(compared.narrowing, 3.5709664 / 1.7597716, 1e-6);
}

TEST(ComparePairs, FindsExactlyNothingInEqualPairs) {
  const std::vector<double> values = {0.1, 0.7, 1e300, -3};
  const PairedMeans compared = ComparePairs(values, values, 0.95);
  EXPECT_EQ(compared.num_equal, 4);
  EXPECT_EQ(compared.difference, 0);
  EXPECT_EQ(compared.interval, (Interval{0, 0}));
  EXPECT_EQ(compared.p, 1);
}

TEST(ComparePairs, FindsAConstantDifferenceForCertain) {
  const std::vector<double> a = {1, 5, 9};
  const std::vector<double> b = {3, 7, 11};
  const PairedMeans compared = ComparePairs(a, b, 0.95);
  EXPECT_EQ(compared.interval, (Interval{2, 2}));
  EXPECT_EQ(compared.p, 0);
  EXPECT_EQ(compared.narrowing, std::numeric_limits<double>::infinity());
}

TEST(ComparePairs, ConcludesNothingFromOnePairOrNone) {
  const std::vector<double> one = {1};
  EXPECT_EQ(ComparePairs(one, one, 0.95).interval, Interval());
  EXPECT_TRUE(std::isnan(ComparePairs(one, one, 0.95).p));
  EXPECT_TRUE(std::isnan(ComparePairs({}, {}, 0.95).difference));
  EXPECT_EQ(ComparePairs({}, {}, 0.95).num_pairs, 0);
}

TEST(ComparePairs, ConcludesNothingFromWhatIsNotFinite) {
  const std::vector<double> a = {1, 2, 3};
  const std::vector<double> b = {1, std::numeric_limits<double>::infinity(), 3};
  EXPECT_TRUE(std::isnan(ComparePairs(a, b, 0.95).p));
  EXPECT_EQ(ComparePairs(a, b, 0.95).interval, Interval());
  EXPECT_EQ(ComparePairs(b, b, 0.95).difference, 0);
}

}  // namespace shoal
