#include "lib/run/run/wake_rule.h"

#include <gtest/gtest.h>

namespace shoal::wake_rule_test {

constexpr int64_t kBuffer_bytes = 212'992;
constexpr auto kFew = static_cast<int64_t>(WakeRule::kFew);
constexpr int64_t kFits = kBuffer_bytes / WakeRule::kBytesOfDatagram;

/// Takes a step with this many datagrams at `now_us`.
void Step(WakeRule* rule, int64_t num_datagrams, int64_t now_us) {
  for (int64_t i = 0; i < num_datagrams; ++i) rule->OnDatagram();
  rule->OnStep(now_us);
}

TEST(WakeRule, WakesForAllBeforeTheFirstStep) {
  EXPECT_FALSE(WakeRule(kBuffer_bytes).SleepsThrough(0));
}

TEST(WakeRule, SleepsThroughTheMessagesOfAStepButNotForLong) {
  WakeRule rule(kBuffer_bytes);
  constexpr int64_t kNow_us = 1'000'000;
  Step(&rule, 10, kNow_us);
  EXPECT_TRUE(rule.SleepsThrough(kNow_us));
  EXPECT_EQ(rule.Timeout(100'000, kNow_us + 10'000), WakeRule::kLongestSleep_us - 10'000);
  EXPECT_EQ(rule.Timeout(5'000, kNow_us + 10'000), 5'000);
  constexpr int64_t kLater_us = kNow_us + WakeRule::kLongestSleep_us;
  EXPECT_FALSE(rule.SleepsThrough(kLater_us));
  EXPECT_EQ(rule.Timeout(100'000, kLater_us), 100'000);
}

TEST(WakeRule, StaysAwakeAfterAStepWhoseMessagesMightNotFit) {
  WakeRule rule(kBuffer_bytes);
  Step(&rule, 2 * kFits, 0);
  int64_t num_awake = 0;
  for (int64_t step = 1; step < 200; ++step) {
    num_awake += rule.SleepsThrough(step) ? 0 : 1;
    Step(&rule, 0, step);
  }
  EXPECT_GT(num_awake, 50) << "reports of a second come once in ten steps";
  EXPECT_TRUE(rule.SleepsThrough(199)) << "it is forgotten in the end";
}

TEST(WakeRule, ReadsManyMessagesWhileTheOthersStillWork) {
  WakeRule rule(kBuffer_bytes);
  for (int64_t step = 0; step < 50; ++step) Step(&rule, 2 * kFew, step);
  EXPECT_FALSE(rule.SleepsThrough(49));
  for (int64_t step = 50; step < 100; ++step) {
    Step(&rule, step % 10 == 0 ? kFew : kFew / 4, step);
  }
  EXPECT_TRUE(rule.SleepsThrough(99)) << "some more now and then are few all the same";
}

}  // namespace shoal::wake_rule_test
