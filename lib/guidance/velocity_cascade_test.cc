#include "lib/guidance/velocity_cascade.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lib/guidance/test_vectors.h"

namespace shoal::velocity_cascade_test {

using Eigen::Vector3d;

constexpr double kUMax_mps = 2.5;

TEST(BudgetSum, HandsDownWhatALayerDoesNotSpend) {
  BudgetSum sum(2);
  EXPECT_EQ(sum.weight(), 1);
  sum.Add({1, 0, 0});
  EXPECT_EQ(sum.weight(), 0.5);
  sum.Add({0, 1, 0});
  EXPECT_EQ(sum.weight(), 0.25);
  sum.Add({0, 0, 2});
  EXPECT_EQ(sum.weight(), 0);
  sum.Add({-9, 0, 0});
  EXPECT_EQ(sum.Velocity_mps(), Vector3d(1, 0.5, 0.5));
}

TEST(BudgetSum, WithoutABudgetStandsStill) {
  BudgetSum sum(0);
  sum.Add(Vector3d::Zero());
  EXPECT_EQ(sum.weight(), 1);
  sum.Add({1, 0, 0});
  EXPECT_EQ(sum.weight(), 0);
  EXPECT_EQ(sum.Velocity_mps(), Vector3d::Zero());
}

TEST(VelocityCascade, IgnoresAllElseWhenANeighbourIsTooNear) {
  TargetScene scene;
  scene.target = {.id = 0, .position_m = {500, 0, 0}, .velocity_mps = {2, 0, 0}};
  scene.group = {{.id = 2, .position_m = {8, 0, 0}}};
  EXPECT_EQ(DesiredVelocity(VelocityCascade{}, kUMax_mps, scene.Seen()),
            Vector3d(-kUMax_mps, 0, 0));
}

TEST(VelocityCascade, MovesAsTheTargetDoesWhereNothingElseIsWanted) {
  TargetScene scene;
  scene.target = {.id = 0, .position_m = {100, 0, 0}, .velocity_mps = {1.5, 0.5, 0.1}};
  EXPECT_EQ(DesiredVelocity(VelocityCascade{}, kUMax_mps, scene.Seen()), Vector3d(1.5, 0.5, 0.1));
}

TEST(VelocityCascade, OfAnyNumberOfLayersIsTheirSumByRank) {
  TargetScene scene;
  scene.target = {.id = 0, .position_m = {155, 0, 0}, .velocity_mps = {0, 1, 0}};
  scene.group = {{.id = 2, .position_m = {0, 25, 0}}};
  EXPECT_EQ(DesiredVelocity(VelocityCascade{{}}, kUMax_mps, scene.Seen()), Vector3d::Zero());
  const VelocityCascade four{
      {SurvivalSonarLayer{}, SurvivalGroupLayer{}, FormationLayer{}, FeedForwardLayer{}}};
  const Vector3d v_mps = DesiredVelocity(four, kUMax_mps, scene.Seen());
  const double eighth_mps = kUMax_mps / 8;
  EXPECT_NEAR(v_mps.x(), eighth_mps * 7 / 8, 1e-12);
  EXPECT_NEAR(v_mps.y(), -eighth_mps + 1 * 49.0 / 64, 1e-12);
}

// Two followers with layers of their own: what one is given never changes the other.
TEST(VelocityCascade, BelongsToOneVehicle) {
  TargetScene scene;
  scene.target = {.id = 0, .position_m = {60, 0, 0}};
  const VelocityCascade one;
  VelocityCascade other = one;
  other.layers = {FormationLayer{.r_safe_m = 5, .r_inner_m = 20, .r_follow_m = 30}};
  EXPECT_LT(DesiredVelocity(one, kUMax_mps, scene.Seen()).x(), 0);
  EXPECT_GT(DesiredVelocity(other, kUMax_mps, scene.Seen()).x(), 0);
}

RC_GTEST_PROP(VelocityCascade, TurnsWithTheWorldAndKeepsToTheGreatestSpeed, ()) {
  const TargetScene scene = AnyTargetScene();
  const double angle_rad = DrawBetween(-3.1, 3.1);
  const Vector3d v_mps = DesiredVelocity(VelocityCascade{}, kUMax_mps, scene.Seen());
  const Vector3d turned_mps =
      DesiredVelocity(VelocityCascade{}, kUMax_mps, scene.Turned(angle_rad).Seen());
  RC_ASSERT((turned_mps - AboutZ(angle_rad) * v_mps).norm() < 1e-8);
  RC_ASSERT(v_mps.norm() <= kUMax_mps * (1 + 1e-12));
}

}  // namespace shoal::velocity_cascade_test
