#include "lib/helm/behaviors/max_depth.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::max_depth_test {

TEST(MaxDepth, LikesEveryDepthAboveItsLimitAlikeAndNoneBelowItsTolerance) {
  TestVessel vessel;
  vessel.own.depth_m = 12;
  MaxDepthBehavior behavior({.max_depth = 30, .tolerance = 10, .depth_slack_var = "SLACK"});
  const BehaviorAnswer answer = vessel.Run(behavior);
  ASSERT_TRUE(answer.objective.has_value());
  EXPECT_DOUBLE_EQ(ValueAt(*answer.objective, 0, 0, 0), 100);
  EXPECT_DOUBLE_EQ(ValueAt(*answer.objective, 0, 0, 30), 100);
  EXPECT_DOUBLE_EQ(ValueAt(*answer.objective, 0, 0, 35), 50);
  EXPECT_DOUBLE_EQ(ValueAt(*answer.objective, 0, 0, 40), 0);
  EXPECT_EQ(PostOf(answer, "SLACK"), VariableValue(18.0));
  EXPECT_TRUE(behavior.is_constraint());
}

TEST(MaxDepth, WarnsWhereTheHelmDoesNotDecideAboutDepth) {
  TestVessel vessel;
  vessel.domain.depth_m = {};
  MaxDepthBehavior behavior({.max_depth = 30});
  EXPECT_NE(vessel.Run(behavior).warning, "");
}

}  // namespace shoal::max_depth_test
