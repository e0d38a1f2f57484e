#include "lib/base/time/seconds.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace shoal::seconds_test {

// 2^53 us are 285 years: up to there every microsecond is a double of its own.
RC_GTEST_PROP(Microseconds, AreThoseThatSecondsWereMadeOf, ()) {
  const int64_t limit_us = int64_t{1} << 50;
  const auto time_us = *rc::gen::inRange<int64_t>(-limit_us, limit_us);
  RC_ASSERT(Microseconds(Seconds(time_us)) == time_us);
}

TEST(Microseconds, AreRoundedAndNotCutOff) {
  EXPECT_EQ(Microseconds(0.1 + 0.2), 300'000);
  EXPECT_EQ(Microseconds(-1.9999996), -2'000'000);
}

TEST(SecondsBetween, CountFromTheFirstToTheSecond) {
  EXPECT_EQ(SecondsBetween(1'000'000, 3'500'000), 2.5);
  EXPECT_EQ(SecondsBetween(3'500'000, 1'000'000), -2.5);
}

}  // namespace shoal::seconds_test
