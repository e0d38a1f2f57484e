#include "lib/helm/behaviors/heading_bias.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::heading_bias_test {

TEST(HeadingBias, LikesTheHalfCircleOnItsSide) {
  TestVessel vessel;
  vessel.own.motion.heading_deg = 300;
  HeadingBiasBehavior right(HeadingBiasOptions{});
  const Objective to_right = *vessel.Run(right).objective;
  EXPECT_EQ(ValueAt(to_right, 300, 0), 100);
  EXPECT_EQ(ValueAt(to_right, 60, 0), 100);
  EXPECT_EQ(ValueAt(to_right, 299, 0), 0);
  HeadingBiasBehavior left({.bias = "left"});
  const Objective to_left = *vessel.Run(left).objective;
  EXPECT_EQ(ValueAt(to_left, 299, 0), 100);
  EXPECT_EQ(ValueAt(to_left, 301, 0), 0);
}

}  // namespace shoal::heading_bias_test
