#include "lib/vehicle/guidance/constant_bearing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::constant_bearing_test {

using Eigen::Vector3d;

constexpr double kUMax_mps = 2.5;
const ConstantBearingLaw kLaw{.lookahead_m = 50, .r_safe_m = 10};

Vector3d Velocity(const Vector3d& target_m, const Vector3d& v_t_mps) {
  TargetScene scene;
  scene.target = {.id = 0, .position_m = target_m, .velocity_mps = v_t_mps};
  return DesiredVelocity(kLaw, kUMax_mps, scene.Seen());
}

TEST(ConstantBearing, ApproachesATargetAtRest) {
  const Vector3d v_mps = Velocity({2000, 0, 0}, {0, 0, 0});
  EXPECT_NEAR(v_mps.x(), kUMax_mps, 0.01);
  EXPECT_EQ(v_mps.y(), 0);
}

TEST(ConstantBearing, SlowsDownTowardTheSafeDistanceAndStopsThere) {
  EXPECT_NEAR(Velocity({60, 0, 0}, {0, 0, 0}).x(), kUMax_mps / std::sqrt(2), 1e-12);
  EXPECT_EQ(Velocity({10, 0, 0}, {0, 0, 0}), Vector3d::Zero());
  EXPECT_EQ(Velocity({10, 0, 0}, {1, 1, 0}), Vector3d(1, 1, 0));
}

TEST(ConstantBearing, MovesAwayInsideTheSafeDistance) {
  EXPECT_LT(Velocity({5, 0, 0}, {0, 0, 0}).x(), 0);
  // Also from a target that leaves, and from one at full speed.
  EXPECT_LT(Velocity({5, 0, 0}, {1, 0, 0}).x(), 1);
  EXPECT_LT(Velocity({5, 0, 0}, {kUMax_mps, 0, 0}).x(), kUMax_mps);
}

TEST(ConstantBearing, PartsFromATargetThatCoincides) {
  EXPECT_GT(Velocity({0, 0, 0}, {0, 0, 0}).norm(), 0);
}

TEST(ConstantBearing, DoesWhatItCanForATargetFasterThanItself) {
  const Vector3d abeam_mps = Velocity({100, 0, 0}, {0, 5, 0});
  EXPECT_TRUE(abeam_mps.allFinite());
  EXPECT_NEAR(abeam_mps.norm(), kUMax_mps, 1e-12);
  EXPECT_GT(abeam_mps.y(), 0);
  EXPECT_NEAR((Velocity({100, 0, 0}, {3, 0, 0}) - Vector3d(kUMax_mps, 0, 0)).norm(), 0, 1e-12);
}

TEST(ConstantBearing, WithoutATargetWantsNothing) {
  EXPECT_EQ(DesiredVelocity(kLaw, kUMax_mps, {}), Vector3d::Zero());
}

// The bearing stays: relative to the target the vehicle moves on the line between them.
RC_GTEST_PROP(ConstantBearing, KeepsTheBearingOfATargetItCanFollow, ()) {
  const Vector3d target_m = VectorWithin(300);
  const Vector3d v_t_mps = VectorWithin(1.4);
  RC_PRE(target_m.norm() > 1);
  const Vector3d relative_mps = Velocity(target_m, v_t_mps) - v_t_mps;
  RC_ASSERT(relative_mps.cross(target_m.normalized()).norm() < 1e-9);
  const double closing_mps = relative_mps.dot(target_m.normalized());
  const bool is_outside = target_m.norm() > kLaw.r_safe_m;
  RC_ASSERT((is_outside ? closing_mps : -closing_mps) >= -1e-12);
}

RC_GTEST_PROP(ConstantBearing, TurnsWithTheWorldAndKeepsToTheGreatestSpeed, ()) {
  const TargetScene scene = AnyTargetScene();
  const double angle_rad = DrawBetween(-3.1, 3.1);
  const Vector3d v_mps = DesiredVelocity(kLaw, kUMax_mps, scene.Seen());
  const Vector3d turned_mps = DesiredVelocity(kLaw, kUMax_mps, scene.Turned(angle_rad).Seen());
  RC_ASSERT((turned_mps - AboutZ(angle_rad) * v_mps).norm() < 1e-8);
  RC_ASSERT(v_mps.norm() <= kUMax_mps * (1 + 1e-12));
}

// A pursuit: comes to the safe distance and never nearer.
RC_GTEST_PROP(ConstantBearing, EndsAtTheSafeDistance, ()) {
  TargetScene scene;
  scene.target.position_m = VectorWithin(200);
  scene.target.velocity_mps = VectorWithin(0.8);
  RC_PRE(scene.target.position_m.norm() > 15);
  for (int i = 0; i < 2'000; ++i) {
    const Vector3d v_mps = DesiredVelocity(kLaw, kUMax_mps, scene.Seen());
    scene.own.position_m += v_mps * 0.5;
    scene.target.position_m += scene.target.velocity_mps * 0.5;
    RC_ASSERT((scene.target.position_m - scene.own.position_m).norm() > 9.9);
  }
  RC_ASSERT((scene.target.position_m - scene.own.position_m).norm() < 12);
}

}  // namespace shoal::constant_bearing_test
