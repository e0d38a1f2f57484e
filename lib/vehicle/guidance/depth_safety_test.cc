#include "lib/vehicle/guidance/depth_safety.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::depth_safety_test {

const DepthSafety kLimits{.z_max_m = 100, .z_min_m = 0, .z_safe_m = 5};

double Limited(double z_m, double own_mps, double command_mps, double seabed_z_m = 6000) {
  return ApplyDepthSafety(kLimits, seabed_z_m, z_m, own_mps, {1, 2, command_mps}).z();
}

TEST(DepthSafetyLimit, LeavesACommandAloneAboveTheSafeDepth) {
  EXPECT_EQ(Limited(94.9, 1, 1), 1);
  EXPECT_EQ(Limited(30, 1, 1, 50), 1);
}

TEST(DepthSafetyLimit, BrakesInProportionBelowIt) {
  EXPECT_NEAR(Limited(97.5, 0, 1), 0.5, 1e-12);
  EXPECT_NEAR(Limited(97.5, 1, 1), 0, 1e-12);
  EXPECT_NEAR(Limited(150, 1, 1), -1, 1e-12);
  EXPECT_NEAR(Limited(47.5, 0, 1, 50), 0.5, 1e-12);
}

TEST(DepthSafetyLimit, LetsAVehicleComeUpAgain) {
  EXPECT_EQ(Limited(99, -1, 0.5), 0.5);
  EXPECT_EQ(Limited(99, 0, -1), -1);
}

TEST(DepthSafetyLimit, BrakesAVehicleThatLeavesTheWater) {
  EXPECT_EQ(Limited(0, -1, -1), -1);
  EXPECT_NEAR(Limited(-2.5, 0, -1), -0.5, 1e-12);
  EXPECT_NEAR(Limited(-5, -1, -1), 1, 1e-12);
  EXPECT_EQ(Limited(-5, 0, 1), 1);
}

TEST(DepthSafetyLimit, WithoutAKnownFloorGoesByTheGreatestDepth) {
  EXPECT_NEAR(Limited(97.5, 0, 1, std::numeric_limits<double>::infinity()), 0.5, 1e-12);
  EXPECT_DEATH(Limited(97.5, 0, 1, std::numeric_limits<double>::quiet_NaN()),
               "inputs of guidance are finite");
}

TEST(DepthSafetyLimit, ClimbsOverAFloorThatRises) {
  DepthSafety limits = kLimits;
  limits.climb_mps = 0.5;
  const auto v_z = [&](double z_m, double command_mps) {
    return ApplyDepthSafety(limits, 50, z_m, 0, {2, 0, command_mps}).z();
  };
  EXPECT_EQ(v_z(44, 0), 0) << "above the safe depth";
  EXPECT_NEAR(v_z(47.5, 0), -0.25, 1e-12);
  EXPECT_NEAR(v_z(50, 0), -0.5, 1e-12);
  EXPECT_NEAR(v_z(60, 1), -0.5, 1e-12);
  EXPECT_EQ(v_z(49, -2), -2) << "already faster";
}

RC_GTEST_PROP(DepthSafetyLimit, NeverAddsToAMotionTowardTheFloor, ()) {
  const double z_m = DrawBetween(-10, 120);
  const double own_mps = DrawBetween(-2, 2);
  const Eigen::Vector3d command_mps = VectorWithin(2);
  const Eigen::Vector3d limited_mps = ApplyDepthSafety(kLimits, 90, z_m, own_mps, command_mps);
  RC_ASSERT(limited_mps.head<2>() == command_mps.head<2>());
  if (z_m > 85) RC_ASSERT(limited_mps.z() <= command_mps.z());
  if (z_m >= 90 && own_mps >= 0) RC_ASSERT(limited_mps.z() <= 0);
  if (z_m >= 0 && z_m <= 85) RC_ASSERT(limited_mps == command_mps);
  if (z_m < 0) RC_ASSERT(limited_mps.z() >= command_mps.z());
}

}  // namespace shoal::depth_safety_test
