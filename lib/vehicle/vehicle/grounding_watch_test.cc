#include "lib/vehicle/vehicle/grounding_watch.h"

#include <gtest/gtest.h>

namespace shoal::grounding_watch_test {

TEST(GroundingWatch, FindsAVehicleOnceWhileItIsAground) {
  GroundingWatch watch(2);
  EXPECT_FALSE(watch.Look(0, 1));
  EXPECT_TRUE(watch.Look(0, 0)) << "its keel touches";
  EXPECT_FALSE(watch.Look(0, -3));
  EXPECT_FALSE(watch.Look(0, 0));
}

TEST(GroundingWatch, FindsItAgainOnceItWasAfloat) {
  GroundingWatch watch(1);
  EXPECT_TRUE(watch.Look(0, -0.1));
  EXPECT_FALSE(watch.Look(0, 0.4)) << "too little to be afloat";
  EXPECT_FALSE(watch.Look(0, -0.1));
  EXPECT_FALSE(watch.Look(0, 0.6));
  EXPECT_TRUE(watch.Look(0, -0.1));
}

TEST(GroundingWatch, KeepsVehiclesApart) {
  GroundingWatch watch(2);
  EXPECT_TRUE(watch.Look(0, -1));
  EXPECT_TRUE(watch.Look(1, -1));
}

}  // namespace shoal::grounding_watch_test
