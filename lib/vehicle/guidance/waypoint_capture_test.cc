#include "lib/vehicle/guidance/waypoint_capture.h"

#include <gtest/gtest.h>

namespace shoal::waypoint_capture_test {

constexpr CaptureRule kRule{.capture_radius_m = 5, .slip_radius_m = 15, .capture_line = false};
const Leg kNorth{.from_m = {0, 0}, .to_m = {0, 100}};

TEST(WaypointCapture, HappensJustInsideTheCaptureRadius) {
  WaypointCapture capture(kRule, kNorth, {0, 0});
  EXPECT_FALSE(capture.Reached({0, 94.9}));
  EXPECT_TRUE(capture.Reached({0, 95.1}));
}

TEST(WaypointCapture, HappensOnceAPassWithinTheSlipRadiusGoesAway) {
  WaypointCapture capture(kRule, kNorth, {10, 0});
  EXPECT_FALSE(capture.Reached({10, 90}));
  EXPECT_FALSE(capture.Reached({10, 100}));
  EXPECT_TRUE(capture.Reached({10, 104}));
}

TEST(WaypointCapture, DoesNotHappenOnAPassOutsideTheSlipRadius) {
  WaypointCapture capture(kRule, kNorth, {16, 0});
  for (int y = 0; y < 200; ++y) EXPECT_FALSE(capture.Reached({16, y * 1.0}));
}

TEST(WaypointCapture, DoesNotHappenWhileTheVesselStillTurnsRoundNearThePoint) {
  WaypointCapture capture(kRule, {.from_m = {0, 88}, .to_m = {0, 100}}, {0, 88});
  EXPECT_FALSE(capture.Reached({0, 87}));
  EXPECT_FALSE(capture.Reached({2, 86}));
  EXPECT_FALSE(capture.Reached({3, 88}));
  EXPECT_TRUE(capture.Reached({2, 96}));
}

TEST(WaypointCapture, WithoutASlipRadiusWaitsForTheCaptureRadius) {
  WaypointCapture capture({.capture_radius_m = 5, .slip_radius_m = 0}, kNorth, {6, 0});
  for (int y = 0; y < 200; ++y) EXPECT_FALSE(capture.Reached({6, y * 1.0}));
}

TEST(WaypointCapture, HappensAtTheCaptureLineHoweverFarAway) {
  WaypointCapture capture({.capture_radius_m = 5, .slip_radius_m = 0, .capture_line = true}, kNorth,
                          {80, 0});
  EXPECT_FALSE(capture.Reached({80, 99.9}));
  EXPECT_TRUE(capture.Reached({80, 100.1}));
}

}  // namespace shoal::waypoint_capture_test
