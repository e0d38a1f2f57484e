#include "lib/helm/behaviors/min_altitude.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::min_altitude_test {

TEST(MinAltitude, AllowsDepthsThatKeepTheVesselOffTheFloor) {
  TestVessel vessel;
  vessel.own.depth_m = 20;
  vessel.own.altitude_m = 15;
  MinAltitudeBehavior behavior({.min_altitude = 10});
  const Objective objective = *vessel.Run(behavior).objective;
  EXPECT_EQ(ValueAt(objective, 0, 0, 25), 100);
  EXPECT_EQ(ValueAt(objective, 0, 0, 26), 0);
  EXPECT_TRUE(behavior.is_constraint());
}

TEST(MinAltitude, WantsTheSurfaceWhereTheWaterIsTooShallow) {
  TestVessel vessel;
  vessel.own.depth_m = 2;
  vessel.own.altitude_m = 3;
  MinAltitudeBehavior behavior({.min_altitude = 10});
  EXPECT_EQ(vessel.Best(vessel.Run(behavior)).depth_m, 0);
}

TEST(MinAltitude, StopsWithoutAnAltitudeOrWarnsIfAsked) {
  TestVessel vessel;
  vessel.own.altitude_m = -1;
  MinAltitudeBehavior critical({.min_altitude = 10});
  EXPECT_NE(vessel.Run(critical).error, "");
  MinAltitudeBehavior lenient({.min_altitude = 10, .missing_altitude_critical = false});
  EXPECT_EQ(vessel.Run(lenient).error, "");
  EXPECT_NE(vessel.Run(lenient).warning, "");
}

}  // namespace shoal::min_altitude_test
