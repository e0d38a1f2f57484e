// Warnings of missions in which nothing is tested, with their exact texts.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/mission/file/load.h"

namespace shoal::validate_conduct_test {

/// Returns the warnings of a mission of two vehicles 50 m apart. `alpha` and `rest` are added to
/// the table of alpha, which begins in line 3, and to the file's end, line 8.
std::vector<std::string> WarningsOf(const std::string& alpha, const std::string& rest = "",
                                    const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded = LoadMissionText(
      "[mission]\nduration_s = 60\n[[vehicle]]\nname = \"alpha\"\n" + alpha +
          "\n[[vehicle]]\nname = \"bravo\"\nstart = {x_m = 50, y_m = 0, heading_deg = 0}\n" + rest,
      "m.toml", overrides);
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.warnings;
}

using Lines = std::vector<std::string>;
const std::string kDeployed = "helm_options = {deploy_at_start = true}";
const std::string kTask =
    "[[vehicle.task]]\nname = \"way\"\nkind = \"waypoints\"\npoints = [[5, 5]]\n";
const std::string kNeverDeployed =
    "m.toml:1:1: warning: no vehicle is ever deployed, so every helm stays in PARK: write "
    "helm_options "
    "= {deploy_at_start = true} in a [[vehicle]], or an [[event]] with command = \"deploy\"";

TEST(Conduct, WarnsWhereNoVehicleIsEverDeployed) {
  EXPECT_EQ(WarningsOf("", kTask), Lines{kNeverDeployed});
  EXPECT_EQ(
      WarningsOf("", kTask + "[[event]]\nat_s = 1\nvehicle = \"bravo\"\ncommand = \"park\"\n"),
      Lines{kNeverDeployed});
}

TEST(Conduct, IsSilentWhereAnEventOrAMessageDeploys) {
  EXPECT_EQ(WarningsOf(kDeployed, kTask), Lines{});
  EXPECT_EQ(
      WarningsOf("", kTask + "[[event]]\nat_s = 1\nvehicle = \"all\"\ncommand = \"deploy\"\n"),
      Lines{});
  EXPECT_EQ(WarningsOf("", kTask + "[[event]]\nat_s = 1\n[event.message]\nsrc_node = \"alpha\"\n"
                                   "dest_node = \"bravo\"\nvar_name = \"HELM_COMMAND\"\n"
                                   "string_val = \"deploy\"\n"),
            Lines{});
}

TEST(Conduct, IsSilentWhereAProgramOfTheUserMayDeploy) {
  EXPECT_EQ(WarningsOf("", kTask + "[[participant]]\nname = \"planner\"\n"), Lines{});
  EXPECT_EQ(WarningsOf("helm = \"none\"", kTask), Lines{});
}

TEST(Conduct, WarnsWhereNoVehicleHasATask) {
  EXPECT_EQ(WarningsOf(kDeployed),
            Lines{"m.toml:1:1: warning: no vehicle has a task, so those that are deployed keep "
                  "station: write a [[vehicle.task]]"});
}

TEST(Conduct, WarnsOfAVehicleThatNoReportCanReach) {
  EXPECT_EQ(WarningsOf(kDeployed + "\nnode_reporter = \"none\"", kTask),
            Lines{"m.toml:7:1: warning: bravo will receive no report: no other vehicle has a "
                  "node_reporter"});
}

TEST(Conduct, WarnsOfVehiclesThatStartInContact) {
  const std::string near = "\nstart = {x_m = 48, y_m = 0, heading_deg = 0}";
  EXPECT_EQ(WarningsOf(kDeployed + near, kTask),
            Lines{"m.toml:9:9: warning: bravo starts 2.00 m from alpha, less than 3.00 m: a "
                  "collision, by which the mission fails; start it elsewhere, or write [mission] "
                  "collisions = \"allowed\""});
  EXPECT_EQ(WarningsOf(kDeployed + near, kTask, {"mission.collisions=allowed"}), Lines{});
}

TEST(Conduct, WarnsOfAnArrivalThatIsMetBeforeTheVehicleHasLeft) {
  const std::string arrival = "[[expect]]\nkind = \"arrival\"\nvehicle = \"alpha\"\n";
  EXPECT_EQ(
      WarningsOf(kDeployed, kTask + arrival),
      Lines{"m.toml:13:1: warning: alpha starts 0.0 m from the point, so this is met before it "
            "has left: write stays = true, or another point"});
  EXPECT_EQ(WarningsOf(kDeployed, kTask + arrival + "stays = true\n"), Lines{});
  EXPECT_EQ(WarningsOf(kDeployed, kTask + arrival + "point = [0, 21]\n"), Lines{});
}

}  // namespace shoal::validate_conduct_test
