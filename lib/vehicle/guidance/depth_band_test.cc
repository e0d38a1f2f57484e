#include "lib/vehicle/guidance/depth_band.h"

#include <gtest/gtest.h>

namespace shoal::depth_band_test {

TEST(DepthBand, IsLeftFarOffAndUntilItIsNear) {
  DepthBand band;
  EXPECT_FALSE(band.IsLeft(-0.2, 1));
  EXPECT_TRUE(band.IsLeft(-0.3, 1));
  EXPECT_TRUE(band.IsLeft(-0.15, 1));
  EXPECT_FALSE(band.IsLeft(-0.05, 1));
}

TEST(DepthBand, GivesUpADepthThatComesNoNearerForAMinute) {
  DepthBand band;
  // The floor keeps it 5 m above the depth.
  for (int i = 0; i < 58; ++i) ASSERT_TRUE(band.IsLeft(-5, 1)) << i;
  for (int i = 0; i < 5; ++i) band.IsLeft(-5, 1);
  EXPECT_FALSE(band.IsLeft(-5, 1));
  EXPECT_FALSE(band.IsLeft(-5.2, 1)) << "it keeps that depth";
  EXPECT_TRUE(band.IsLeft(-5.3, 1));
  EXPECT_FALSE(band.IsLeft(-5.05, 1));
  EXPECT_TRUE(band.IsLeft(-4, 1)) << "the floor has fallen";
}

TEST(DepthBand, IsPatientWithALongWayAndDuringPauses) {
  DepthBand band;
  for (double off_m = -100; off_m < -1; off_m += 0.01) ASSERT_TRUE(band.IsLeft(off_m, 0.1));
  EXPECT_TRUE(band.IsLeft(-1, 3600)) << "a pause";
}

}  // namespace shoal::depth_band_test
