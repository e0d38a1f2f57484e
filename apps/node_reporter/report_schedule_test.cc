#include "apps/node_reporter/report_schedule.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace shoal::report_schedule_test {

std::vector<int64_t> DueTimes(double rate_hz, int64_t tick_us, int64_t num_steps,
                              int64_t start_utime = 0) {
  ReportSchedule schedule(rate_hz, start_utime, tick_us);
  std::vector<int64_t> times;
  for (int64_t step = 0; step < num_steps; ++step) {
    if (schedule.IsDue(start_utime + step * tick_us)) times.push_back(step * tick_us);
  }
  return times;
}

TEST(ReportSchedule, IsDueAtTheStartAndEveryPeriod) {
  EXPECT_EQ(DueTimes(2, 100'000, 16), (std::vector<int64_t>{0, 500'000, 1'000'000, 1'500'000}));
}

TEST(ReportSchedule, CountsFromTheMissionsStart) {
  EXPECT_EQ(DueTimes(2, 100'000, 7, 1'234'567), (std::vector<int64_t>{0, 500'000}));
}

TEST(ReportSchedule, TakesTheFirstStepAfterADueTimeBetweenSteps) {
  EXPECT_EQ(DueTimes(3, 100'000, 11), (std::vector<int64_t>{0, 400'000, 700'000, 1'000'000}));
}

TEST(ReportSchedule, HasNoDriftOverADay) {
  EXPECT_EQ(DueTimes(0.1, 1'000'000, 86'400).size(), 8'640U);
  EXPECT_EQ(DueTimes(0.1, 1'000'000, 86'400).back(), 86'390'000'000);
}

TEST(ReportSchedule, IsDueInEveryStepAtOrAboveTheTickRate) {
  EXPECT_EQ(DueTimes(10, 100'000, 50).size(), 50U);
  EXPECT_EQ(DueTimes(1e300, 100'000, 50).size(), 50U);
}

TEST(ReportSchedule, IsNeverDueAtNoRate) {
  for (const double rate_hz : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(DueTimes(rate_hz, 100'000, 50).empty());
  }
}

RC_GTEST_PROP(ReportSchedule, GivesAsManyReportsAsTheRateDemands, ()) {
  const int rate_mhz = *rc::gen::inRange(1, 20'000);
  const int num_steps = *rc::gen::inRange(1, 400);
  const std::vector<int64_t> due = DueTimes(rate_mhz / 1000.0, 50'000, num_steps);
  const int64_t last_us = (num_steps - 1) * int64_t{50'000};
  RC_ASSERT(static_cast<int64_t>(due.size()) == 1 + last_us * rate_mhz / 1'000'000'000);
}

}  // namespace shoal::report_schedule_test
