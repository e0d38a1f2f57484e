#include "lib/tools/plot/time_marks.h"

#include <gtest/gtest.h>

namespace shoal::time_marks_test {

std::vector<int64_t> TimesOf(const std::vector<TimeMark>& marks) {
  std::vector<int64_t> times;
  for (const TimeMark& mark : marks) times.push_back(mark.time_s);
  return times;
}

/// Returns the marks of a track with a point every `interval_s`, up to `end_s`.
TimeMarks MarksUpTo(double end_s, double interval_s) {
  TimeMarks marks;
  for (int i = 0; i * interval_s <= end_s; ++i) {
    marks.Add(i * interval_s, {.x = i * interval_s, .y = 0});
  }
  return marks;
}

TEST(TimeMarks, StandAtEachSecondOfAShortTrackButItsStart) {
  const TimeMarks marks = MarksUpTo(3.5, 0.1);
  EXPECT_EQ(marks.step_s(), 1);
  EXPECT_EQ(TimesOf(marks.MultiplesOf(1)), (std::vector<int64_t>{1, 2, 3}));
}

TEST(TimeMarks, AreThinnedToRoundTimesWhenThereAreMoreThanFifteen) {
  const TimeMarks marks = MarksUpTo(100, 0.5);
  EXPECT_EQ(marks.step_s(), 10);
  EXPECT_EQ(TimesOf(marks.MultiplesOf(10)),
            (std::vector<int64_t>{10, 20, 30, 40, 50, 60, 70, 80, 90, 100}));
}

TEST(TimeMarks, AreLeftOutWhereTheTrackHasNoPointNearThem) {
  TimeMarks marks;
  marks.Add(0.5, {});
  marks.Add(3.0, {.x = 3, .y = 0});
  marks.Add(5.2, {.x = 5.2, .y = 0});
  EXPECT_EQ(TimesOf(marks.MultiplesOf(1)), (std::vector<int64_t>{3, 5}));
  TimeMarks sparse = MarksUpTo(16, 1);  // A mark every other second from now on.
  ASSERT_EQ(sparse.step_s(), 2);
  sparse.Add(19.5, {});
  EXPECT_EQ(TimesOf(sparse.MultiplesOf(2)).back(), 16);
}

TEST(TimeMarks, StayFifteenInATrackOfAYear) {
  const TimeMarks marks = MarksUpTo(3e7, 43'200);
  EXPECT_EQ(marks.step_s(), 86'400);
  EXPECT_EQ(marks.MultiplesOf(86'400).size(), TimeMarks::kMaxMarks);
}

TEST(TimeMarks, OfAnotherVehiclesCoarserStepAreThoseThatBothHave) {
  const TimeMarks marks = MarksUpTo(14, 0.5);
  EXPECT_EQ(TimesOf(marks.MultiplesOf(10)), (std::vector<int64_t>{10}));
}

}  // namespace shoal::time_marks_test
