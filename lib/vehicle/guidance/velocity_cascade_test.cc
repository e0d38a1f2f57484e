#include "lib/vehicle/guidance/velocity_cascade.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/vehicle/guidance/vectors_testing.h"

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

// The specification's pattern: w[0] = alpha, w[1] = 1 - w[0] s[0], w[2] = w[1] (1 - s[1]) ...
TEST(BudgetSum, GivesTheFirstLayerTheWeightAlpha) {
  BudgetSum sum(2, 0.5);
  EXPECT_EQ(sum.weight(), 0.5);
  sum.Add({1, 0, 0});
  EXPECT_EQ(sum.weight(), 1 - 0.5 * 0.5);
  sum.Add({0, 1, 0});
  EXPECT_EQ(sum.weight(), 0.75 * 0.5);
  sum.Add({0, 0, 0});
  EXPECT_EQ(sum.weight(), 0.75 * 0.5);
  EXPECT_EQ(sum.Velocity_mps(), Vector3d(0.5, 0.75, 0));
}

TEST(BudgetSum, SilencesAFirstLayerOfWeightZero) {
  BudgetSum sum(2, 0);
  sum.Add({2, 0, 0});
  EXPECT_EQ(sum.weight(), 1);
  sum.Add({0, 1, 0});
  EXPECT_EQ(sum.Velocity_mps(), Vector3d(0, 1, 0));
}

RC_GTEST_PROP(VelocityCascade, ShowsSharesThatAddUpToWhatItReturns, ()) {
  TargetScene scene;
  scene.target = {.id = 0, .position_m = VectorWithin(200), .velocity_mps = VectorWithin(2)};
  scene.group = {{.id = 2, .position_m = VectorWithin(50)}};
  const VelocityCascade cascade = {.alpha = DrawBetween(0, 1)};
  const Vector3d way_mps = VectorWithin(1);
  std::vector<LayerShare> shares;
  const Vector3d v_mps = DesiredVelocityOnWay(cascade, kUMax_mps, scene.Seen(), way_mps, &shares);
  RC_ASSERT(shares.size() == 4);
  RC_ASSERT(shares.back().name == "waypoint" && shares.back().velocity_mps == way_mps);
  Vector3d sum_mps = Vector3d::Zero();
  double weight = cascade.alpha;
  for (size_t i = 0; i < shares.size(); ++i) {
    RC_ASSERT(std::abs(shares[i].weight - weight) < 1e-12);
    sum_mps += weight * shares[i].velocity_mps;
    const double spent = std::min(shares[i].velocity_mps.norm() / kUMax_mps, 1.0);
    weight = i == 0 ? 1 - weight * spent : weight * (1 - spent);
  }
  if (sum_mps.norm() > kUMax_mps) sum_mps *= kUMax_mps / sum_mps.norm();
  RC_ASSERT((v_mps - sum_mps).norm() < 1e-12);
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
