#include "lib/helm/behaviors/max_speed.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::max_speed_test {

TEST(MaxSpeed, LikesEverySpeedBelowItsLimitAlikeAndNoneAboveItsTolerance) {
  TestVessel vessel;
  vessel.own.motion.speed_mps = 2.5;
  MaxSpeedBehavior behavior({.max_speed = 2, .tolerance = 1, .speed_slack_var = "SLACK"});
  const BehaviorAnswer answer = vessel.Run(behavior);
  ASSERT_TRUE(answer.objective.has_value());
  EXPECT_DOUBLE_EQ(ValueAt(*answer.objective, 0, 0), 100);
  EXPECT_DOUBLE_EQ(ValueAt(*answer.objective, 0, 20), 100);
  EXPECT_NEAR(ValueAt(*answer.objective, 0, 25), 50, 1e-9);
  EXPECT_NEAR(ValueAt(*answer.objective, 0, 30), 0, 1e-9);
  EXPECT_EQ(PostOf(answer, "SLACK"), VariableValue(-0.5));
  EXPECT_TRUE(behavior.is_constraint());
}

}  // namespace shoal::max_speed_test
