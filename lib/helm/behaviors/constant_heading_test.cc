#include "lib/helm/behaviors/constant_heading.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::constant_heading_test {

TEST(ConstantHeading, PrefersItsHeadingAndPostsTheMismatch) {
  TestVessel vessel;
  vessel.own.motion.heading_deg = 350;
  ConstantHeadingBehavior behavior({.heading = 20, .heading_mismatch_var = "OFF"});
  const BehaviorAnswer answer = vessel.Run(behavior);
  EXPECT_EQ(vessel.Best(answer).course_deg, 20);
  EXPECT_EQ(vessel.Best(answer).speed_mps, -1);
  EXPECT_EQ(PostOf(answer, "OFF"), VariableValue(30.0));
  EXPECT_FALSE(answer.completes);
}

TEST(ConstantHeading, CompletesWithinItsThreshold) {
  TestVessel vessel;
  ConstantHeadingBehavior behavior({.heading = 358, .complete_thresh = 3});
  vessel.own.motion.heading_deg = 2;
  EXPECT_FALSE(vessel.Run(behavior).completes);
  vessel.own.motion.heading_deg = 1;
  EXPECT_TRUE(vessel.Run(behavior).completes);
}

}  // namespace shoal::constant_heading_test
