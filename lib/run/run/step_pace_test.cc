#include "lib/run/run/step_pace.h"

#include <gtest/gtest.h>

#include <string>

namespace shoal::step_pace_test {

constexpr int64_t kPaceTick_us = 100'000;

clock_command_t Order(const std::string& command, double warp = 0) {
  clock_command_t order{};
  order.command = command;
  order.warp = warp;
  return order;
}

TEST(StepPace, MakesStepsDueInStepWithTheWall) {
  StepPace pace(2, kPaceTick_us, "");
  pace.Begin(1'000'000);
  EXPECT_EQ(pace.DueTime(), 1'000'000);
  pace.OnStep(0, 1'000'000);
  EXPECT_EQ(pace.DueTime(), 1'050'000);
  pace.OnStep(1, 1'060'000);  // A little late: the next keeps to the schedule.
  EXPECT_EQ(pace.DueTime(), 1'100'000);
}

TEST(StepPace, IsAlwaysDueAtFullSpeed) {
  StepPace pace(0, kPaceTick_us, "");
  pace.Begin(1'000'000);
  pace.OnStep(7, 1'000'000);
  EXPECT_EQ(pace.DueTime(), 0);
}

TEST(StepPace, CatchesUpTwoTenthsOfASecondAfterAStallAndNoMore) {
  StepPace pace(1, kPaceTick_us, "");
  pace.Begin(0);
  pace.OnStep(0, 0);
  pace.ForgiveStall(250'000);
  EXPECT_EQ(pace.DueTime(), 100'000);
  pace.ForgiveStall(5'000'000);
  EXPECT_EQ(pace.DueTime(), 4'800'000);
}

TEST(StepPace, CountsANewWarpFromTheStepUnderWay) {
  StepPace pace(1, kPaceTick_us, "");
  pace.Begin(0);
  pace.OnStep(0, 0);
  EXPECT_EQ(pace.Execute(Order("warp", 4), 10'000), "");
  EXPECT_EQ(pace.DueTime(), 25'000);
  EXPECT_EQ(pace.Execute(Order("warp", 0.5), 20'000), "");
  EXPECT_EQ(pace.DueTime(), 200'000);
}

TEST(StepPace, IsDueAtOnceWhereTheNewPaceHasPassedIt) {
  StepPace pace(1, kPaceTick_us, "");
  pace.Begin(0);
  pace.OnStep(0, 0);
  EXPECT_EQ(pace.Execute(Order("pause"), 50'000), "");
  EXPECT_TRUE(pace.is_paused());
  EXPECT_EQ(pace.Execute(Order("resume"), 9'000'000), "");
  EXPECT_EQ(pace.DueTime(), 9'000'000);
}

TEST(StepPace, DoesNotMoveForACommandWithoutEffect) {
  StepPace pace(1, kPaceTick_us, "");
  pace.Begin(0);
  pace.OnStep(0, 30'000);
  EXPECT_EQ(pace.Execute(Order("warp", 1), 40'000), "");
  EXPECT_EQ(pace.Execute(Order("resume"), 40'000), "");
  EXPECT_EQ(pace.DueTime(), 100'000);
}

TEST(StepPace, MeasuresItsFactorSoonerAfterAChange) {
  StepPace pace(1, kPaceTick_us, "");
  pace.Begin(0);
  pace.OnStep(0, 0);
  pace.MeasureFactor(499'999);
  EXPECT_EQ(pace.factor(), 0);
  pace.OnStep(4, 400'000);
  pace.MeasureFactor(500'000);  // Steps 0 to 4.
  EXPECT_DOUBLE_EQ(pace.factor(), 1);
  pace.OnStep(14, 1'400'000);
  pace.MeasureFactor(1'499'999);
  EXPECT_DOUBLE_EQ(pace.factor(), 1);
  pace.OnStep(24, 1'450'000);
  pace.MeasureFactor(1'500'000);
  EXPECT_DOUBLE_EQ(pace.factor(), 2);
  EXPECT_EQ(pace.Execute(Order("pause"), 1'500'000), "");
  EXPECT_EQ(pace.factor(), 0);
}

TEST(StepPace, RefusesWhatItCannotDo) {
  StepPace fixed(1, kPaceTick_us, "it keeps to the wall's clock");
  EXPECT_EQ(fixed.Execute(Order("warp", 2), 0), "it keeps to the wall's clock");
  EXPECT_NE(fixed.Execute(Order("seek 5"), 0).find("shoal play"), std::string::npos);
  EXPECT_EQ(fixed.Execute(Order("jump"), 0), "unknown command 'jump': pause, resume or warp");
  StepPace pace(1, kPaceTick_us, "");
  EXPECT_EQ(pace.Execute(Order("warp", 1e-7), 0), "1e-07 is not 0 (max), nor 1e-6 to 1e6");
  EXPECT_EQ(pace.warp(), 1);
}

}  // namespace shoal::step_pace_test
