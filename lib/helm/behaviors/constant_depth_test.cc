#include "lib/helm/behaviors/constant_depth.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::constant_depth_test {

TEST(ConstantDepth, PrefersItsDepthAndPostsTheMismatch) {
  TestVessel vessel;
  vessel.own.depth_m = 18;
  ConstantDepthBehavior behavior({.depth = 20, .depth_mismatch_var = "OFF"});
  const BehaviorAnswer answer = vessel.Run(behavior);
  EXPECT_EQ(vessel.Best(answer).depth_m, 20);
  EXPECT_EQ(vessel.Best(answer).speed_mps, -1);
  EXPECT_EQ(PostOf(answer, "OFF"), VariableValue(2.0));
}

TEST(ConstantDepth, WarnsWhereTheHelmDoesNotDecideAboutDepth) {
  TestVessel vessel;
  vessel.domain.depth_m = {};
  ConstantDepthBehavior behavior({.depth = 20});
  const BehaviorAnswer answer = vessel.Run(behavior);
  EXPECT_FALSE(answer.objective.has_value());
  EXPECT_NE(answer.warning, "");
}

}  // namespace shoal::constant_depth_test
