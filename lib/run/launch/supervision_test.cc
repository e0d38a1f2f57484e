#include "lib/run/launch/supervision.h"

#include <gtest/gtest.h>

namespace shoal::supervision_test {

constexpr int64_t kSecond_us = 1'000'000;

TEST(StartLimit, GrowsWithTheProcessesAndWithTheirTimeout) {
  EXPECT_EQ(StartLimit_us(5, 8), 24 * kSecond_us);
  EXPECT_EQ(StartLimit_us(5, 302), 171 * kSecond_us);
  EXPECT_EQ(StartLimit_us(60, 8), 244 * kSecond_us);
}

TEST(StartLimit, IsNotThatOfAStepWhereTheTimeoutIsShort) {
  EXPECT_EQ(StartLimit_us(0.1, 8), StartLimit_us(5, 8));
}

}  // namespace shoal::supervision_test
