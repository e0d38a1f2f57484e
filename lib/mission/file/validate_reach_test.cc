// What is asked of vehicles that they cannot do, with the exact texts.
#include <gtest/gtest.h>

#include <string>

#include "lib/mission/file/load.h"

namespace shoal::validate_reach_test {

/// Returns the warnings of a mission of 60 s, without those that no report is received. `vehicle`
/// begins in line 7.
std::string WarningsOf(const std::string& vehicle, const std::string& environment = "") {
  const LoadedMission loaded = LoadMissionText(
      "[mission]\nduration_s = 60\n[environment]\n" + environment +
          "\n[[vehicle]]\nname = \"a\"\nhelm_options = {deploy_at_start = true}\n" + vehicle,
      "m.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  std::string text;
  for (const std::string& warning : loaded.warnings) text += warning + "\n";
  return text;
}

const std::string kNext = "[[vehicle.task]]\nname = \"next\"\nkind = \"waypoints\"\n";
const std::string kWaypoints = "[[vehicle.task]]\nkind = \"waypoints\"\n";

TEST(Reach, WarnsOfWaypointsThatTakeLongerThanTheMission) {
  const std::string after = kNext + "points = [[0, 9]]\nspeed_mps = 5\n";
  EXPECT_EQ(WarningsOf(kWaypoints + "points = [[0, 60], [0, 90]]\n" + after), "") << "just in time";
  EXPECT_EQ(WarningsOf(kWaypoints + "points = [[0, 60], [0, 91]]\n" + after),
            "m.toml:10:10: warning: the way to the last point is 91 m long and takes 61 s at 1.5 "
            "m/s, but the mission ends after 60 s: raise duration_s or speed_mps\n");
}

TEST(Reach, WarnsOfWaypointsThatNothingWaitsForWhereTheyTakeHalfAsLongAgain) {
  EXPECT_EQ(WarningsOf(kWaypoints + "points = [[0, 135]]\n"), "") << "it may go on until the end";
  EXPECT_NE(WarningsOf(kWaypoints + "points = [[0, 136]]\n").find("136 m long and takes 91 s"),
            std::string::npos);
  EXPECT_EQ(WarningsOf(kWaypoints + "points = [[0, 136]]\nlaps = 0\n"), "") << "for ever";
}

TEST(Reach, CountsTheWayOfATaskFromTheEndOfTheOneBefore) {
  const std::string near = kWaypoints + "points = [[0, 80]]\n";
  EXPECT_EQ(WarningsOf(near + kNext + "points = [[0, 215]]\n"), "");
  EXPECT_NE(WarningsOf(near + kNext + "points = [[0, 216]]\n").find("136 m long"),
            std::string::npos);
}

TEST(Reach, WarnsOfASurveyThatMustEndAndTakesLongerThanTheMission) {
  const std::string survey =
      "[[vehicle.task]]\nkind = \"survey\"\npolygon = [[0, 0], [100, 0], [100, 100], [0, 100]]\n"
      "lane_spacing_m = 20\n";
  EXPECT_EQ(WarningsOf(survey), "") << "it goes on until the end";
  EXPECT_NE(WarningsOf(survey + kNext + "points = [[0, 9]]\n").find("ends after 60 s"),
            std::string::npos);
}

TEST(Reach, WarnsOfASpeedThatTheCraftDoesNotHave) {
  EXPECT_EQ(WarningsOf(kWaypoints + "points = [[0, 9]]\nspeed_mps = 5\n"), "");
  EXPECT_EQ(
      WarningsOf(kWaypoints + "points = [[0, 9]]\nspeed_mps = 5.5\n"),
      "m.toml:11:13: warning: speed_mps = 5.5 is more than the 5.00 m/s that a reaches at full "
      "thrust: see thrust_map in [vehicle.surface_craft]\n");
}

TEST(Reach, WarnsOfACurrentNearlyAsFastAsTheVehicle) {
  const std::string task = kWaypoints + "points = [[0, 9]]\n";
  EXPECT_EQ(WarningsOf(task, "current = {speed_mps = 1.1}"), "");
  EXPECT_NE(
      WarningsOf(task, "current = {speed_mps = 1.3}")
          .find("the current flows with 1.30 m/s, and a is to go 1.5 m/s relative to the water: it "
                "hardly makes way against it; raise speed_mps"),
      std::string::npos);
  EXPECT_NE(WarningsOf(task, "current = {speed_mps = 1.6}").find("it makes no way against it"),
            std::string::npos);
}

TEST(Reach, WarnsOfReportsOverAMediumThatAVehicleDoesNotHave) {
  const std::string others =
      "[[vehicle]]\nname = \"b\"\nstart = {x_m = 50}\nmedia = [\"vhf\"]\n"
      "[[medium]]\nname = \"vhf\"\nkind = \"radio\"\nrange_m = 100\n"
      "[comms]\nreports_over = \"vhf\"\n";
  EXPECT_EQ(WarningsOf("media = [\"vhf\"]\n" + kWaypoints + "points = [[0, 9]]\n" + others), "");
  EXPECT_EQ(
      WarningsOf("media = [\"direct\"]\n" + kWaypoints + "points = [[0, 9]]\n" + others),
      "m.toml:8:9: warning: no report of a can be sent: reports_over = vhf in [comms], and it "
      "has direct; add a medium to either\n");
}

}  // namespace shoal::validate_reach_test
