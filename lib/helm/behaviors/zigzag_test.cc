#include "lib/helm/behaviors/zigzag.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::zigzag_test {

using Flags = std::vector<std::string>;

const ZigzagOptions kOptions = {.stem_hdg = 10, .speed = 1.5};

BehaviorAnswer RunOn(TestVessel& vessel, Behavior& behavior, double heading_deg) {
  vessel.own.motion.heading_deg = heading_deg;
  return vessel.Run(behavior);
}

TEST(Zigzag, GoesToEitherSideOfItsStemByTurns) {
  TestVessel vessel;
  ZigzagBehavior zigzag(kOptions);
  BehaviorAnswer answer = RunOn(vessel, zigzag, 10);
  EXPECT_EQ(answer.flags, Flags({"zigflag"}));
  EXPECT_EQ(vessel.Best(answer).course_deg, 325);
  EXPECT_DOUBLE_EQ(vessel.Best(answer).speed_mps, 1.5);
  EXPECT_EQ(vessel.Best(RunOn(vessel, zigzag, 331)).course_deg, 325);
  answer = RunOn(vessel, zigzag, 330);
  EXPECT_EQ(answer.flags, Flags({"zagflag"}));
  EXPECT_EQ(vessel.Best(answer).course_deg, 55);
  EXPECT_TRUE(RunOn(vessel, zigzag, 60).completes);  // Past the course that was set.
  EXPECT_FALSE(RunOn(vessel, zigzag, 60).objective.has_value());
}

TEST(Zigzag, BeginsToStarboardWhereThatIsAskedFor) {
  TestVessel vessel;
  ZigzagOptions options = kOptions;
  options.zig_first = "starboard";
  ZigzagBehavior zigzag(options);
  const BehaviorAnswer answer = RunOn(vessel, zigzag, 10);
  EXPECT_EQ(answer.flags, Flags({"zagflag"}));
  EXPECT_EQ(vessel.Best(answer).course_deg, 55);
}

TEST(Zigzag, TakesItsStemAndSpeedFromTheVesselWhenItBegins) {
  TestVessel vessel;
  vessel.own.motion.speed_mps = 2.5;
  ZigzagBehavior zigzag({.stem_on_active = true, .speed_on_active = true});
  EXPECT_EQ(vessel.Best(RunOn(vessel, zigzag, 100)).course_deg, 55);
  EXPECT_DOUBLE_EQ(vessel.Best(RunOn(vessel, zigzag, 90)).speed_mps, 2.5);
  (void)zigzag.Idle(vessel.Inputs());
  EXPECT_EQ(vessel.Best(RunOn(vessel, zigzag, 200)).course_deg, 155);
}

TEST(Zigzag, EndsAfterItsDistanceAlongTheStem) {
  TestVessel vessel;
  ZigzagOptions options = kOptions;
  options.stem_hdg = 0;
  options.max_zig_legs = 0;
  options.max_stem_odo = 100;
  ZigzagBehavior zigzag(options);
  EXPECT_FALSE(vessel.RunAt(zigzag, {0, 0}).completes);
  EXPECT_FALSE(vessel.RunAt(zigzag, {300, 99}).completes);
  EXPECT_TRUE(vessel.RunAt(zigzag, {300, 101}).completes);
}

TEST(Zigzag, TurnsAheadOfItsHeadingWhereItIsFierce) {
  TestVessel vessel;
  ZigzagOptions options = kOptions;
  options.fierce_zigging = true;
  ZigzagBehavior zigzag(options);
  EXPECT_EQ(vessel.Best(RunOn(vessel, zigzag, 10)).course_deg, 325);
  EXPECT_EQ(vessel.Best(RunOn(vessel, zigzag, 350)).course_deg, 305);
}

}  // namespace shoal::zigzag_test
