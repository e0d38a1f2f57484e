#include "lib/tools/analysis/age_teeth.h"

#include <gtest/gtest.h>

namespace shoal::age_teeth_test {

constexpr int64_t kSecond_us = 1'000'000;

/// From `taken_s` on an age grew from `begin_s` for `length_s`.
AgeTooth Tooth(int64_t taken_s, int64_t begin_s, int64_t length_s) {
  return {.taken_utime = taken_s * kSecond_us,
          .begin_us = begin_s * kSecond_us,
          .length_us = length_s * kSecond_us};
}

TEST(AgeTeeth, HaveFiguresOverTime) {
  const std::vector<AgeTooth> teeth = {Tooth(0, 0, 10), Tooth(10, 2, 10)};
  EXPECT_DOUBLE_EQ(MeanAge_s(teeth), 6);
  EXPECT_DOUBLE_EQ(MaxAge_s(teeth), 12);
  EXPECT_DOUBLE_EQ(AgePercentile_s(teeth, 0.1), 2);
  EXPECT_DOUBLE_EQ(AgePercentile_s(teeth, 0.95), 11);
  EXPECT_DOUBLE_EQ(AgePercentile_s(teeth, 1), 12);
}

TEST(AgeTeeth, AreTheirLargestAgeWhereTheyTakeNoTime) {
  const std::vector<AgeTooth> teeth = {Tooth(5, 3, 0)};
  EXPECT_DOUBLE_EQ(MeanAge_s(teeth), 3);
  EXPECT_DOUBLE_EQ(AgePercentile_s(teeth, 0.5), 3);
}

TEST(AgeTeeth, AreCutAtATime) {
  const std::vector<AgeTooth> teeth =
      TeethFrom(std::vector<AgeTooth>{Tooth(0, 0, 10), Tooth(10, 2, 10)}, 14 * kSecond_us);
  ASSERT_EQ(teeth.size(), 1U);
  EXPECT_EQ(teeth[0].taken_utime, 14 * kSecond_us);
  EXPECT_EQ(teeth[0].begin_us, 6 * kSecond_us);
  EXPECT_EQ(teeth[0].length_us, 6 * kSecond_us);
  EXPECT_TRUE(TeethFrom(teeth, 21 * kSecond_us).empty());
}

}  // namespace shoal::age_teeth_test
