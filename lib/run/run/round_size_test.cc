#include "lib/run/run/round_size.h"

#include <gtest/gtest.h>

namespace shoal::round_size_test {

TEST(RoundSize, IsLargeBeforeAnythingIsKnown) { EXPECT_EQ(RoundSize().most(), RoundSize::kMax); }

TEST(RoundSize, FillsTheTargetWithMessagesOfTheMeasuredCost) {
  RoundSize size;
  for (int i = 0; i < 10; ++i) size.AfterRound(40, 40 * 1000);
  EXPECT_EQ(size.most(), RoundSize::kTarget_us / 1000);
}

TEST(RoundSize, FollowsWhenMessagesBecomeDearer) {
  RoundSize size;
  for (int i = 0; i < 1000; ++i) size.AfterRound(50, 250);
  EXPECT_EQ(size.most(), RoundSize::kMax);
  for (int i = 0; i < 3; ++i) size.AfterRound(100, 100'000);
  EXPECT_LE(size.most(), 2 * RoundSize::kTarget_us / 1000);
}

TEST(RoundSize, FollowsWhenMessagesBecomeCheaper) {
  RoundSize size;
  for (int i = 0; i < 1000; ++i) size.AfterRound(100, 200'000);
  EXPECT_EQ(size.most(), RoundSize::kTarget_us / 2000);
  for (int i = 0; i < 100; ++i) size.AfterRound(100, 500);
  EXPECT_EQ(size.most(), RoundSize::kMax);
}

TEST(RoundSize, StaysWithinItsBoundsForAnyCostOfARound) {
  RoundSize size;
  size.AfterRound(1, 3'600'000'000);
  EXPECT_EQ(size.most(), RoundSize::kLeast);
  RoundSize free;
  free.AfterRound(1'000'000'000, 0);
  EXPECT_EQ(free.most(), RoundSize::kMax);
}

TEST(RoundSize, LearnsNothingFromAnEmptyRound) {
  RoundSize size;
  size.AfterRound(0, 1'000'000);
  EXPECT_EQ(size.most(), RoundSize::kMax);
}

}  // namespace shoal::round_size_test
