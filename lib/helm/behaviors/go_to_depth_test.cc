#include "lib/helm/behaviors/go_to_depth.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::go_to_depth_test {

using Flags = std::vector<std::string>;

/// At the depth that is given, 1 s a call.
struct Diver {
  explicit Diver(const GoToDepthOptions& options) : behavior(options) {}

  BehaviorAnswer At(double depth_m) {
    vessel.time_s += 1;
    vessel.own.depth_m = depth_m;
    return vessel.Run(behavior);
  }

  TestVessel vessel = {};
  GoToDepthBehavior behavior;
};

TEST(GoToDepth, VisitsEachDepthForItsTimeAndCompletes) {
  Diver diver({.depths = {{20, 2}, {50, 0}}});
  BehaviorAnswer answer = diver.At(0);
  EXPECT_EQ(diver.vessel.Best(answer).depth_m, 20);
  EXPECT_EQ(answer.state, "to 20 m");
  answer = diver.At(19.5);
  EXPECT_EQ(answer.flags, Flags({"capture_flag"}));
  EXPECT_EQ(answer.state, "at 20 m");
  EXPECT_EQ(diver.vessel.Best(diver.At(20)).depth_m, 20);
  EXPECT_EQ(diver.vessel.Best(diver.At(20)).depth_m, 50);
  answer = diver.At(50);
  EXPECT_TRUE(answer.completes);
  EXPECT_EQ(answer.flags, Flags({"capture_flag"}));
  answer = diver.At(50);
  EXPECT_FALSE(answer.completes);
  EXPECT_FALSE(answer.objective.has_value());
}

TEST(GoToDepth, HasReachedADepthThatItCrossedBetweenTwoIterations) {
  Diver diver({.depths = {{20, 100}}});
  (void)diver.At(15);
  EXPECT_EQ(diver.At(25).flags, Flags({"capture_flag"}));
}

TEST(GoToDepth, RepeatsItsList) {
  Diver diver({.depths = {{20, 0}, {50, 0}}, .repeat = 1});
  EXPECT_FALSE(diver.At(20).completes);
  EXPECT_FALSE(diver.At(50).completes);
  EXPECT_FALSE(diver.At(20).completes);
  EXPECT_TRUE(diver.At(50).completes);
}

TEST(GoToDepth, BeginsAnewWithOtherDepthsAndKeepsItsPlaceOtherwise) {
  Diver diver({.depths = {{20, 0}, {50, 0}}});
  (void)diver.At(20);
  diver.behavior.Reconfigure({.depths = {{20, 0}, {50, 0}}, .capture_delta = 2});
  EXPECT_EQ(diver.vessel.Best(diver.At(21)).depth_m, 50);
  diver.behavior.Reconfigure({.depths = {{70, 0}}});
  EXPECT_EQ(diver.vessel.Best(diver.At(21)).depth_m, 70);
}

TEST(GoToDepth, BeginsAnewAfterItHasBeenIdleSinceTheEnd) {
  Diver diver({.depths = {{20, 0}}});
  EXPECT_TRUE(diver.At(20).completes);
  (void)diver.behavior.Idle(diver.vessel.Inputs());
  EXPECT_TRUE(diver.At(0).objective.has_value());
}

}  // namespace shoal::go_to_depth_test
