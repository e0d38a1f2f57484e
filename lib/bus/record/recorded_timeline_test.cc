#include "lib/bus/record/recorded_timeline.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <vector>

namespace shoal::recorded_timeline_test {

constexpr int64_t kSecond_us = 1'000'000;
constexpr int64_t kStart_utime = 5 * kSecond_us;

/// Advances a second at a time from `from_s` on, so often.
void Advance(RecordedTimeline* line, int64_t from_s, int64_t times) {
  for (int64_t i = 0; i < times; ++i) line->Advance(kStart_utime + (from_s + i) * kSecond_us);
}

TEST(RecordedTimeline, CountsFromTheStart) {
  RecordedTimeline line(kStart_utime);
  line.Advance(kStart_utime - kSecond_us / 2);
  EXPECT_EQ(line.now_us(), -kSecond_us / 2);
  Advance(&line, 0, 100);
  EXPECT_EQ(line.now_us(), 99 * kSecond_us);
  EXPECT_EQ(line.UtimeOf(line.now_us()), kStart_utime + 99 * kSecond_us);
  EXPECT_EQ(line.num_odd(), 0);
}

TEST(RecordedTimeline, StandsStillWhileTimesAreALittleEarlier) {
  RecordedTimeline line(kStart_utime);
  Advance(&line, 0, 10);
  line.Advance(kStart_utime + 9 * kSecond_us - 300'000);
  EXPECT_EQ(line.now_us(), 9 * kSecond_us);
  EXPECT_EQ(line.num_odd(), 0);
}

TEST(RecordedTimeline, IgnoresASingleOddTime) {
  constexpr int64_t kLeast = std::numeric_limits<int64_t>::min();
  constexpr int64_t kMax = std::numeric_limits<int64_t>::max();
  RecordedTimeline line(kStart_utime);
  Advance(&line, 0, 10);
  for (const int64_t utime : {kLeast, kMax, int64_t{-1}, 7'200 * kSecond_us}) line.Advance(utime);
  EXPECT_EQ(line.now_us(), 9 * kSecond_us);
  Advance(&line, 10, 1);
  EXPECT_EQ(line.now_us(), 10 * kSecond_us);
  EXPECT_EQ(line.num_odd(), 4);
  EXPECT_EQ(line.num_shifts(), 0);
}

TEST(RecordedTimeline, FindsTheStartAfterAnImpossibleFirstTime) {
  RecordedTimeline line(kStart_utime);
  line.Advance(std::numeric_limits<int64_t>::max());
  Advance(&line, 3, 2);
  EXPECT_EQ(line.now_us(), 4 * kSecond_us);
}

TEST(RecordedTimeline, GoesOnFromWhereItWasWhenTheClockGoesBack) {
  RecordedTimeline line(kStart_utime);
  Advance(&line, 0, 1000);
  Advance(&line, 0, 100);  // the mission began again
  EXPECT_EQ(line.num_shifts(), 1);
  EXPECT_EQ(line.now_us(), (999 + 100 - RecordedTimeline::kWitnesses) * kSecond_us);
  EXPECT_EQ(line.UtimeOf(line.now_us()), kStart_utime + 99 * kSecond_us);
}

TEST(RecordedTimeline, KeepsAPauseOfHours) {
  RecordedTimeline line(kStart_utime);
  Advance(&line, 0, 10);
  Advance(&line, 20'000, 100);
  EXPECT_EQ(line.now_us(), 20'099 * kSecond_us);
  EXPECT_EQ(line.num_shifts(), 0);
}

TEST(RecordedTimeline, LeavesOutYearsInWhichNothingWasRecorded) {
  RecordedTimeline line(kStart_utime);
  Advance(&line, 0, 10);
  Advance(&line, 100'000'000, 100);
  EXPECT_EQ(line.num_shifts(), 1);
  EXPECT_LT(line.now_us(), 200 * kSecond_us);
}

RC_GTEST_PROP(RecordedTimeline, NeverGoesBackWhateverTheTimes,
              (int64_t start, const std::vector<int64_t>& times)) {
  RecordedTimeline line(start);
  int64_t last_us = line.now_us();
  for (const int64_t utime : times) {
    for (int i = 0; i < 20; ++i) {
      const bool was_begun = line.is_begun();
      line.Advance(utime);
      RC_ASSERT(!was_begun || line.now_us() >= last_us);
      last_us = line.now_us();
    }
  }
}

}  // namespace shoal::recorded_timeline_test
