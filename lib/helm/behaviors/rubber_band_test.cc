#include "lib/helm/behaviors/rubber_band.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::rubber_band_test {

TEST(RubberBand, PullsTowardItsPointTheHarderTheFartherItIs) {
  TestVessel vessel;
  RubberBandBehavior behavior({.point = Eigen::Vector2d(0, 0), .stiffness = 0.5});
  EXPECT_FALSE(vessel.RunAt(behavior, {0, 3.9}).objective.has_value());
  EXPECT_NEAR(vessel.Best(vessel.RunAt(behavior, {9.5, 0})).course_deg, 270, 0.1);
  EXPECT_NEAR(vessel.Best(vessel.RunAt(behavior, {9.5, 0})).speed_mps, 0.6, 0.051);
  EXPECT_EQ(vessel.RunAt(behavior, {0, 14}).urgency, 1);
  EXPECT_NEAR(vessel.RunAt(behavior, {0, 45}).urgency, 2, 1e-12);
}

TEST(RubberBand, HoldsToWhereItBeganWithoutAPoint) {
  TestVessel vessel;
  RubberBandBehavior behavior(RubberBandOptions{});
  EXPECT_FALSE(vessel.RunAt(behavior, {50, 50}).objective.has_value());
  EXPECT_NEAR(vessel.Best(vessel.RunAt(behavior, {50, 80})).course_deg, 180, 0.1);
  (void)behavior.Idle(vessel.Inputs());
  EXPECT_FALSE(vessel.RunAt(behavior, {50, 80}).objective.has_value());
}

}  // namespace shoal::rubber_band_test
