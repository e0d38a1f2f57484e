#include "lib/vehicle/control/heading_pid.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace shoal::heading_pid_test {

TEST(HeadingPid, TurnsTheShorterWayAcrossNorth) {
  HeadingPid pid({.kp = 1});
  EXPECT_DOUBLE_EQ(pid.Update(10, 350, 0, 0.1), 20);
  EXPECT_DOUBLE_EQ(pid.Update(350, 10, 0, 0.1), -20);
}

TEST(HeadingPid, DampsTheYawRateAndNotTheChangeOfTheDesiredHeading) {
  HeadingPid pid({.kp = 1, .kd = 2});
  EXPECT_DOUBLE_EQ(pid.Update(0, 0, 0, 0.1), 0);
  EXPECT_DOUBLE_EQ(pid.Update(30, 0, 0, 0.1), 30);
  EXPECT_DOUBLE_EQ(pid.Update(30, 0, 5, 0.1), 20);
}

TEST(HeadingPid, RemovesASteadyErrorByItsIntegral) {
  HeadingPid pid({.kp = 1, .ki = 0.5});
  for (int i = 0; i < 10; ++i) pid.Update(2, 0, 0, 0.1);
  EXPECT_NEAR(pid.Update(0, 0, 0, 0.1), 0.5 * 2 * 1.0, 1e-12);
}

TEST(HeadingPid, KeepsItsIntegralWithinTheLimit) {
  HeadingPid pid({.kp = 0, .ki = 1, .integral_limit_pct = 20});
  for (int i = 0; i < 1000; ++i) pid.Update(90, 0, 0, 0.1);
  EXPECT_DOUBLE_EQ(pid.Update(0, 0, 0, 0.1), 20);
}

TEST(HeadingPid, DoesNotWindUpWhileTheRudderIsHardOver) {
  HeadingPid pid({.kp = 2, .ki = 1});
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(pid.Update(170, 0, 0, 0.1), 100);
  EXPECT_DOUBLE_EQ(pid.Update(0, 0, 0, 0.1), 0);
}

TEST(HeadingPid, ForgetsItsIntegralWhenReset) {
  HeadingPid pid({.kp = 0, .ki = 1});
  pid.Update(50, 0, 0, 1);
  pid.Reset();
  EXPECT_DOUBLE_EQ(pid.Update(0, 0, 0, 1), 0);
}

RC_GTEST_PROP(HeadingPid, StaysWithinFullRudderAndMirrorsForTheMirroredError, ()) {
  HeadingPid pid({.kp = 1.2, .ki = 0.1, .kd = 0.6});
  HeadingPid mirrored({.kp = 1.2, .ki = 0.1, .kd = 0.6});
  for (int i = 0; i < 20; ++i) {
    const double error_deg = *rc::gen::inRange(-179, 180);
    const double rate_degps = *rc::gen::inRange(-50, 51);
    const double rudder_pct = pid.Update(error_deg, 0, rate_degps, 0.1);
    RC_ASSERT(std::abs(rudder_pct) <= 100);
    RC_ASSERT(mirrored.Update(-error_deg, 0, -rate_degps, 0.1) == -rudder_pct);
  }
}

}  // namespace shoal::heading_pid_test
