// What a Remus 100 does with its fins where there is no way on, and under the surface.
#include <gtest/gtest.h>

#include "tests/closed_loops/swimming_auv.h"

namespace shoal::at_the_surface_test {

TEST(AtTheSurface, ItSwimsJustUnderWaterWithItsFinsAtRest) {
  SwimmingAuv auv({});
  auv.Start({.heading_deg = 90, .speed_mps = 2, .depth_m = 5});
  auv.Swim(ToDepth(0), 150);
  const Extremes seen = auv.Swim(ToDepth(0), 60);
  EXPECT_LT(seen.stern_plane_deg, 1);
  EXPECT_LT(seen.rudder_deg, 1);
  EXPECT_GT(seen.least_z_m, 0.08);
  EXPECT_LT(seen.greatest_z_m, 0.2);
}

TEST(AtTheSurface, ItRestsWithItsFinsCentredAndGoesOnWithoutAJump) {
  SwimmingAuv auv({});
  auv.Start({.heading_deg = 90, .speed_mps = 2, .depth_m = 5});
  auv.Swim(ToDepth(0), 150);
  auv.Swim(ToDepth(0, 0), 60);
  const Extremes rest = auv.Swim(ToDepth(0, 0), 120);
  EXPECT_EQ(rest.stern_plane_deg, 0);
  EXPECT_EQ(rest.rudder_deg, 0);
  const double z_m = auv.z_m();
  const Extremes restart = auv.Swim(ToDepth(0), 100);
  EXPECT_LT(restart.greatest_z_m, z_m + 0.3);
  EXPECT_GT(restart.least_z_m, z_m - 0.3);
}

TEST(AtDepth, ItGoesOnAfterARestWithoutAJump) {
  SwimmingAuv auv({}, FlatFloor(100));
  auv.Start({.heading_deg = 90, .speed_mps = 2, .depth_m = 20});
  auv.Swim(ToDepth(20), 60);
  auv.Swim(ToDepth(25, 0), 300);  // Asked for more depth than it can take without way.
  const double z_m = auv.z_m();
  const Extremes restart = auv.Swim(ToDepth(z_m), 100);
  EXPECT_LT(restart.greatest_z_m, z_m + 0.3);
  EXPECT_GT(restart.least_z_m, z_m - 0.3);
}

TEST(ALightHull, IsHeldAtItsDepthUnderWayAndFloatsUpAtRest) {
  SwimmingAuv auv({.buoyancy_by_weight = 1.01}, FlatFloor(100));
  auv.Start({.heading_deg = 90, .speed_mps = 2, .depth_m = 10});
  auv.Swim(ToDepth(10), 200);
  const Extremes level = auv.Swim(ToDepth(10), 60);
  EXPECT_GT(level.least_z_m, 9.9);
  EXPECT_LT(level.greatest_z_m, 10.1);
  auv.Swim(ToDepth(10, 0), 300);
  EXPECT_LT(auv.z_m(), 0.15);
  EXPECT_EQ(auv.actuators().stern_plane_deg, 0);
}

}  // namespace shoal::at_the_surface_test
