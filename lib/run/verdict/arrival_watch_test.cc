#include "lib/run/verdict/arrival_watch.h"

#include <gtest/gtest.h>

namespace shoal::arrival_watch_test {

const Eigen::Vector2d kThere(20, 0);
const Eigen::Vector2d kJustNotThere(20.001, 0);
const Eigen::Vector2d kFarAway(500, 0);

ArrivalWatch Watch(bool stays) {
  return ArrivalWatch({.point_m = {0, 0}, .within_m = 20, .by_s = 600, .stays = stays});
}

TEST(ArrivalWatch, FailsAVehicleThatWasNeverSeen) {
  EXPECT_FALSE(Watch(false).Find().passed);
  EXPECT_FALSE(Watch(true).Find().passed);
}

TEST(ArrivalWatch, PassesAVehicleThatIsJustThereJustInTime) {
  ArrivalWatch watch = Watch(false);
  watch.Look(kThere, 600);
  watch.Look(kFarAway, 700);
  EXPECT_TRUE(watch.Find().passed);
  EXPECT_EQ(watch.Find().numbers, "there at 600.0 s");
}

TEST(ArrivalWatch, ShowsByHowMuchAVehicleIsLate) {
  ArrivalWatch watch = Watch(false);
  watch.Look(kFarAway, 600);
  watch.Look(kThere, 600.1);
  EXPECT_FALSE(watch.Find().passed);
  EXPECT_EQ(watch.Find().numbers, "there at 600.1 s, 0.1 s late");
}

TEST(ArrivalWatch, ShowsByHowMuchAVehicleIsTooFar) {
  ArrivalWatch watch = Watch(false);
  watch.Look(kFarAway, 1);
  watch.Look(kJustNotThere, 2);
  watch.Look(kFarAway, 3);
  EXPECT_FALSE(watch.Find().passed);
  EXPECT_EQ(watch.Find().numbers, "closest: 20.0 m at 2.0 s, 0.001 m too far");
}

TEST(ArrivalWatch, WantsAVehicleToStayWhereThatIsAsked) {
  ArrivalWatch watch = Watch(true);
  watch.Look(kThere, 500);
  watch.Look(kJustNotThere, 550);
  EXPECT_FALSE(watch.Find().passed);
  watch.Look(kThere, 600);
  watch.Look(kThere, 900);
  EXPECT_TRUE(watch.Find().passed);
  EXPECT_EQ(watch.Find().numbers, "there from 600.0 s on");
}

TEST(ArrivalWatch, ShowsHowFarAwayAVehicleEnds) {
  ArrivalWatch watch = Watch(true);
  watch.Look(kThere, 500);
  watch.Look(kFarAway, 900);
  EXPECT_FALSE(watch.Find().passed);
  EXPECT_EQ(watch.Find().numbers,
            "500.0 m away at the end, 480.0 m too far (closest: 20.0 m at 500.0 s)");
}

TEST(ArrivalWatch, FailsAVehicleThatLeavesAndComesBackLate) {
  ArrivalWatch watch = Watch(true);
  watch.Look(kThere, 500);
  watch.Look(kFarAway, 601);
  watch.Look(kThere, 612);
  EXPECT_FALSE(watch.Find().passed);
  EXPECT_EQ(watch.Find().numbers, "there from 612.0 s on, 12.0 s late");
}

}  // namespace shoal::arrival_watch_test
