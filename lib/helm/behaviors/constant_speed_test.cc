#include "lib/helm/behaviors/constant_speed.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::constant_speed_test {

TEST(ConstantSpeed, PrefersItsSpeedAndPostsTheMismatch) {
  TestVessel vessel;
  vessel.own.motion.speed_mps = 2;
  ConstantSpeedBehavior behavior({.speed = 1.5, .speed_mismatch_var = "OFF"});
  const BehaviorAnswer answer = vessel.Run(behavior);
  EXPECT_DOUBLE_EQ(vessel.Best(answer).speed_mps, 1.5);
  EXPECT_EQ(vessel.Best(answer).course_deg, -1);
  EXPECT_EQ(PostOf(answer, "OFF"), VariableValue(0.5));
}

TEST(ConstantSpeed, TakesOverAnotherSpeed) {
  TestVessel vessel;
  ConstantSpeedBehavior behavior({.speed = 1.5});
  behavior.Reconfigure({.speed = 3});
  EXPECT_DOUBLE_EQ(vessel.Best(vessel.Run(behavior)).speed_mps, 3);
}

}  // namespace shoal::constant_speed_test
