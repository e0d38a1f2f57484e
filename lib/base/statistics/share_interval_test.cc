#include "lib/base/statistics/share_interval.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shoal {

// Newcombe 1998, table I: methods 4 and 5 at 95 %.
TEST(WilsonInterval, IsThatOfNewcombesTable) {
  const Interval first = WilsonInterval(81, 263, 0.95);
  EXPECT_NEAR(first.low, 0.2535, 5e-5);
  EXPECT_NEAR(first.high, 0.3682, 5e-5);
  const Interval second = WilsonInterval(15, 148, 0.95);
  EXPECT_NEAR(second.low, 0.0598, 5e-5);
  EXPECT_NEAR(second.high, 0.1644, 5e-5);
  const Interval third = WilsonInterval(0, 20, 0.95);
  EXPECT_NEAR(third.low, 0, 5e-5);
  EXPECT_NEAR(third.high, 0.2005, 5e-5);
  const Interval fourth = WilsonInterval(1, 29, 0.95);
  EXPECT_NEAR(fourth.low, 0.0018, 5e-5);
  EXPECT_NEAR(fourth.high, 0.1963, 5e-5);
}

TEST(ExactShareInterval, IsThatOfNewcombesTable) {
  const Interval first = ExactShareInterval(81, 263, 0.95);
  EXPECT_NEAR(first.low, 0.2527, 5e-5);
  EXPECT_NEAR(first.high, 0.3676, 5e-5);
  const Interval second = ExactShareInterval(15, 148, 0.95);
  EXPECT_NEAR(second.low, 0.0578, 5e-5);
  EXPECT_NEAR(second.high, 0.1617, 5e-5);
  EXPECT_NEAR(ExactShareInterval(0, 20, 0.95).high, 0.1684, 5e-5);
}

TEST(ShareInterval, ContainsBothOfTheOthers) {
  const Interval both = ShareInterval(15, 148, 0.95);
  EXPECT_EQ(both.low, ExactShareInterval(15, 148, 0.95).low);
  EXPECT_EQ(both.high, WilsonInterval(15, 148, 0.95).high);
}

TEST(ShareInterval, IsSymmetric) {
  for (const int successes : {0, 1, 7, 50}) {
    const Interval of_successes = ShareInterval(successes, 100, 0.95);
    const Interval of_failures = ShareInterval(100 - successes, 100, 0.95);
    EXPECT_NEAR(of_successes.low, 1 - of_failures.high, 1e-12) << successes;
    EXPECT_NEAR(of_successes.high, 1 - of_failures.low, 1e-12) << successes;
  }
}

TEST(ShareInterval, ReachesTheEndsOfWhatWasSeen) {
  EXPECT_EQ(ShareInterval(0, 50, 0.95).low, 0);
  EXPECT_EQ(ShareInterval(50, 50, 0.95).high, 1);
  EXPECT_EQ(ShareInterval(0, 0, 0.95), (Interval{0, 1}));
  EXPECT_EQ(ShareInterval(1, 2, 1), (Interval{0, 1}));
}

TEST(BoundOfNone, IsAThousandthAfterAlmostThreeThousand) {
  EXPECT_LT(BoundOfNone(2995, 0.95), 1e-3);
  EXPECT_GT(BoundOfNone(2994, 0.95), 1e-3);
}

TEST(BoundOfNone, IsWhereNothingIsSeenWithTheRestOfTheConfidence) {
  EXPECT_NEAR(std::pow(1 - BoundOfNone(17, 0.99), 17), 0.01, 1e-12);
  EXPECT_EQ(BoundOfNone(0, 0.95), 1);
  EXPECT_NEAR(BoundOfNone(1, 0.95), 0.95, 1e-15);
}

}  // namespace shoal
