#include "lib/tools/moos/import_outlook.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/mission/file/load.h"

namespace shoal::import_outlook_test {

constexpr std::string_view kVehicle =
    "[mission]\nduration_s = 600\n[[vehicle]]\nname = \"ida\"\n[vehicle.variables]\n"
    "DEPLOY = \"false\"\nPATROL = \"false\"\nRETURN = \"true\"\n";
constexpr std::string_view kLeg =
    "[[vehicle.behavior]]\nkind = \"waypoint\"\nname = \"leg\"\nspeed = 1\n"
    "condition = [\"DEPLOY = true\", \"RETURN = false\", \"PATROL = true\"]\n"
    "points = [[90, 0]]\n";

VehicleOutlook OutlookOf(const std::string& more) {
  const LoadedMission loaded = LoadMissionText(std::string(kVehicle) + more, "m");
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  return OutlooksOf(loaded.mission).at(0);
}

TEST(Outlook, NamesTheBehaviorsThatMoveAVehicle) {
  const VehicleOutlook outlook = OutlookOf(
      "[[vehicle.behavior]]\nkind = \"timer\"\nname = \"soon\"\nduration = 20\n"
      "endflag = \"PATROL = true\"\n" +
      std::string(kLeg));
  EXPECT_TRUE(outlook.moves);
  EXPECT_EQ(outlook.why, "leg");
}

TEST(Outlook, StatesTheConditionAndTheOrderThatAVehicleWaitsFor) {
  const VehicleOutlook outlook = OutlookOf(std::string(kLeg) +
                                           "[[order]]\nname = \"go\"\nvehicle = \"ida\"\ncommand = "
                                           "\"set\"\nargument = \"PATROL=true\"\n");
  EXPECT_FALSE(outlook.moves);
  EXPECT_EQ(outlook.why, "leg waits for PATROL = true (shoal send go)");
}

TEST(Outlook, WaitsForTheMissionsEvents) {
  const VehicleOutlook outlook =
      OutlookOf(std::string(kLeg) +
                "[[event]]\nat_s = 300\nvehicle = \"all\"\ncommand = \"set\"\n"
                "argument = \"PATROL=true\"\n");
  EXPECT_TRUE(outlook.moves);
  EXPECT_EQ(outlook.why, "leg, from 300 s on");
}

TEST(Outlook, StatesWhyABehaviorCannotMoveAVehicle) {
  EXPECT_EQ(OutlookOf("").why, "it has no behaviors");
  EXPECT_EQ(OutlookOf("[[vehicle.behavior]]\nkind = \"waypoint\"\nname = \"leg\"\nspeed = 1\n"
                      "updates = \"UP\"\n[[vehicle.behavior]]\nkind = \"timer\"\nname = \"t\"\n"
                      "[[vehicle.behavior]]\nkind = \"trail\"\nname = \"f_\"\nupdates = \"F\"\n"
                      "templating = \"spawn\"\n")
                .why,
            "leg waits for points by UP; t gives no speed; f_ is only begun for what comes near");
}

TEST(Outlook, IsThatAVehicleWithTasksMoves) {
  EXPECT_TRUE(OutlookOf("[[vehicle.task]]\nkind = \"station_keep\"\n").moves);
}

}  // namespace shoal::import_outlook_test
