#include "lib/base/statistics/mean_interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace shoal {

TEST(Moments, OfFewValues) {
  EXPECT_TRUE(std::isnan(MomentsOf({}).mean));
  const std::vector<double> one = {4};
  EXPECT_EQ(MomentsOf(one).mean, 4);
  EXPECT_TRUE(std::isnan(MomentsOf(one).standard_deviation));
}

TEST(Moments, LoseNothingFarFromZero) {
  const std::vector<double> values = {1e9 + 1, 1e9 + 2, 1e9 + 3};
  EXPECT_EQ(MomentsOf(values).mean, 1e9 + 2);
  EXPECT_EQ(MomentsOf(values).standard_deviation, 1);
}

// Student's own example (1908, "The probable error of a mean", the additional hours of sleep): the
// interval that every textbook gives for it.
TEST(MeanInterval, IsThatOfStudentsSleepers) {
  const std::vector<double> hours = {1.2, 2.4, 1.3, 1.3, 0.0, 1.0, 1.8, 0.8, 4.6, 1.4};
  const Interval interval = MeanInterval(MomentsOf(hours), 0.95);
  EXPECT_NEAR(interval.low, 0.7001142, 1e-6);
  EXPECT_NEAR(interval.high, 2.4598858, 1e-6);
}

TEST(MeanInterval, HasNoEndsWithoutTwoValues) {
  const std::vector<double> one = {4};
  EXPECT_EQ(MeanInterval(MomentsOf({}), 0.95), Interval());
  EXPECT_EQ(MeanInterval(MomentsOf(one), 0.95), Interval());
}

TEST(MeanInterval, IsAPointWhereAllAreEqual) {
  const std::vector<double> equal = {0.1, 0.1, 0.1};
  EXPECT_EQ(MeanInterval(MomentsOf(equal), 0.95), (Interval{0.1, 0.1}));
}

TEST(MeanInterval, HasNoEndsWhereAValueIsNotFinite) {
  for (const double odd : {std::nan(""), std::numeric_limits<double>::infinity(), 1e308}) {
    const std::vector<double> values = {1, -odd, odd, 2};
    EXPECT_EQ(MeanInterval(MomentsOf(values), 0.95), Interval()) << odd;
  }
}

}  // namespace shoal
