// What is known beforehand of vehicles that run aground on the mission's own map.
#include <gtest/gtest.h>

#include <string>

#include "lib/mission/file/load.h"

namespace shoal::validate_ground_test {

/// 10 m deep in the West, 10 m high in the East; the coast is at x = 0.
constexpr char kBeach[] =
    "floor = {style = \"flat\", depth_m = 0, range_m = 0, size_m = 200, slope_east = -0.1}\n";

/// `vehicle` begins in line 6.
LoadedMission Load(const std::string& vehicle, const std::string& floor = kBeach) {
  const LoadedMission loaded = LoadMissionText("[mission]\nduration_s = 600\n[environment]\n" +
                                                   floor + "[[vehicle]]\nname = \"a\"\n" + vehicle,
                                               "m.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded;
}

std::string WarningsOf(const LoadedMission& loaded) {
  std::string text;
  for (const std::string& warning : loaded.warnings) text += warning + "\n";
  return text;
}

bool Has(const LoadedMission& loaded, const std::string& text) {
  return WarningsOf(loaded).find(text) != std::string::npos;
}

const std::string kDeployed = "helm_options = {deploy_at_start = true}\n";
const std::string kAuv = "model = \"remus100\"\n" + kDeployed;
const std::string kWay = "[[vehicle.task]]\nkind = \"waypoints\"\npoints = ";
const std::string kPath = "[[vehicle.task]]\nkind = \"path_follow\"\npoints = ";

TEST(Ground, IsASureFailureWhereAnAuvStartsInIt) {
  const LoadedMission loaded =
      Load(kAuv + "start = {x_m = -70, depth_m = 8}\n" + kPath + "[[-70, 50, 8]]\n");
  EXPECT_EQ(loaded.num_sure_failures, 1) << "its path is a warning: it stays above";
  EXPECT_TRUE(
      Has(loaded, "leads at 8 m depth at (-70.0, 1.0), where the floor is at 7 m: it stays"))
      << WarningsOf(loaded);
  EXPECT_TRUE(
      Has(loaded,
          "m.toml:9:9: warning: a starts aground: at (-70, 0) at 8 m depth, the floor is at "
          "7 m; start it elsewhere, or write [mission] grounding = \"allowed\"\n"))
      << WarningsOf(loaded);
}

TEST(Ground, IsASureFailureWhereASurfaceCraftStartsOnLandOrOnTooLittleWater) {
  EXPECT_TRUE(Has(Load("start = {x_m = 20}\n" + kDeployed + kWay + "[[-50, 0]]\n"),
                  "a starts aground: at (20, 0) with a draught of 0.3 m, the map has land; start"));
  const std::string shallow = "start = {x_m = -5}\n" + kDeployed + kWay + "[[-50, 0]]\n";
  EXPECT_EQ(Load(shallow).num_sure_failures, 0) << "half a metre of water";
  EXPECT_EQ(Load("draught_m = 0.6\n" + shallow).num_sure_failures, 1);
}

TEST(Ground, WarnsOfADraughtAndAVerdictWithoutEffect) {
  EXPECT_TRUE(Has(Load(kAuv + "draught_m = 0.6\nstart = {x_m = -70, depth_m = 2}\n"),
                  "draught_m has no effect, as a is not a vessel at the surface: leave it out"));
  const LoadedMission bare = LoadMissionText(
      "[mission]\nduration_s = 60\ngrounding = \"allowed\"\n[[vehicle]]\nname = \"a\"\n"
      "draught_m = 0.5\n",
      "m.toml");
  EXPECT_TRUE(Has(bare,
                  "m.toml:3:13: warning: grounding has no effect, as the mission has no sea "
                  "floor: write [environment] floor, or leave it out"));
  EXPECT_TRUE(Has(bare, "draught_m has no effect, as the mission has no sea floor: leave it out"));
}

TEST(Ground, IsASureFailureWhereAWayLeadsOverLand) {
  const LoadedMission loaded =
      Load("start = {x_m = -50}\n" + kDeployed + kWay + "[[-60, 0], [40, 0]]\n");
  EXPECT_EQ(loaded.num_sure_failures, 1);
  EXPECT_TRUE(Has(loaded,
                  "m.toml:11:10: warning: a's way to here leads with a draught of 0.3 m at "
                  "(-2.0, 0.0), where the floor is at 0.2 m: it runs aground; lead it "
                  "around, or write [mission] grounding = \"allowed\"\n"))
      << WarningsOf(loaded);
}

TEST(Ground, IsNoMoreThanAWarningWhereTheVehicleMayDoOtherwise) {
  const std::string to_land = kWay + "[[40, 0]]\n";
  const std::string start = "start = {x_m = -50}\n";
  EXPECT_EQ(Load(start + kDeployed + to_land).num_sure_failures, 1);
  const LoadedMission parked = Load(start + to_land);
  EXPECT_EQ(parked.num_sure_failures, 0);
  EXPECT_TRUE(Has(parked, "it runs aground"));
  const LoadedMission slow = Load(start + kDeployed + to_land + "speed_mps = 0.05\n");
  EXPECT_EQ(slow.num_sure_failures, 0) << "the mission is over before";
  EXPECT_TRUE(Has(slow, "it runs aground"));
  const LoadedMission behavior = Load(start + kDeployed + to_land +
                                      "[[vehicle.behavior]]\nname = \"still\"\nkind = "
                                      "\"constant_speed\"\nspeed = 0\n");
  EXPECT_EQ(behavior.num_sure_failures, 0);
}

TEST(Ground, WarnsOfAPathBelowTheFloorThatTheVehicleStaysAbove) {
  const LoadedMission loaded =
      Load(kAuv + "start = {x_m = -90}\n" + kPath + "[[-80, 0, 9], [-70, 0, 9]]\n");
  EXPECT_EQ(loaded.num_sure_failures, 0);
  EXPECT_TRUE(Has(loaded,
                  "at 9 m depth at (-79.0, 0.0), where the floor is at 7.9 m: it stays "
                  "seabed_clearance_m = 5 above the floor; write"))
      << WarningsOf(loaded);
  const LoadedMission without =
      Load(kAuv + "start = {x_m = -90}\nremus100 = {seabed_clearance_m = 0}\n" + kPath +
           "[[-80, 0, 9], [-70, 0, 9]]\n");
  EXPECT_EQ(without.num_sure_failures, 1) << WarningsOf(without);
}

TEST(Ground, IsAWarningWhereTheMissionAllowsIt) {
  const LoadedMission loaded =
      LoadMissionText("[mission]\nduration_s = 600\ngrounding = \"allowed\"\n[environment]\n" +
                          std::string(kBeach) + "[[vehicle]]\nname = \"a\"\nstart = {x_m = 20}\n" +
                          kDeployed + kWay + "[[-50, 0]]\n",
                      "m.toml");
  EXPECT_EQ(loaded.num_sure_failures, 0);
  EXPECT_TRUE(Has(loaded, "a starts aground"));
}

TEST(Ground, IsNotLookedForWhereItIsNotKnown) {
  EXPECT_FALSE(
      Has(Load(kAuv + "start = {depth_m = 7}\n" + kPath + "[[-80, 0, 2]]\n", ""), "aground"));
}

}  // namespace shoal::validate_ground_test
