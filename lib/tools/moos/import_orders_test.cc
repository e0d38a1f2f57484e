#include "lib/tools/moos/import_orders.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/mission/file/load.h"
#include "lib/tools/moos/import.h"

namespace shoal::import_orders_test {

/// Two vehicles that go by PATROL, RETURN and STATION_KEEP, and such lines of pMarineViewer.
MoosImport WithButtons(const std::string& lines, std::vector<MoosButton> pokes = {}) {
  const std::string bhv =
      "Behavior = BHV_Waypoint\n{\nname = leg\ncondition = DEPLOY = true\ncondition = PATROL = "
      "true\n"
      "condition = RETURN = false\ncondition = STATION_KEEP = false\nspeed = 1\npoints = 90,0\n}\n";
  const auto moos = [](const std::string& name) {
    return MoosSource{.name = name + ".moos",
                      .text = "Community = " + name + "\nProcessConfig = pHelmIvP\n{\n}\n"};
  };
  return ImportMoos(
      std::vector<MoosSource>{
          moos("ida"),
          moos("jon"),
          {.name = "ida.bhv", .text = bhv},
          {.name = "jon.bhv", .text = bhv},
          {.name = "shore.moos",
           .text = "Community = shore\nProcessConfig = pMarineViewer\n{\n" + lines + "}\n"}},
      {.pokes = std::move(pokes)});
}

std::vector<OrderWords> OrdersOf(const MoosImport& import) {
  const LoadedMission loaded = LoadMissionText(import.mission, "m");
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  return OrdersOf(loaded.mission);
}

using Orders = std::vector<OrderWords>;

TEST(ImportedOrders, AreTheFurtherButtons) {
  const MoosImport import = WithButtons(
      "button_one = DEPLOY # DEPLOY_ALL=true # PATROL_ALL=true\n"
      "button_two = RETURN # RETURN_ALL=true\nbutton_two = PATROL_IDA=false\n"
      "button_three = Go: on! # PATROL_ALL=true # NOBODY_LOOKS=1\n"
      "button_four = ida # STATION_KEEP_JON=true\nbutton_five = OFF # "
      "MOOS_MANUAL_OVERRIDE_ALL=true\n");
  EXPECT_EQ(OrdersOf(import), (Orders{{"return", "all", {"return"}},
                                      {"return", "ida", {"set", "PATROL=false"}},
                                      {"go_on", "all", {"set", "PATROL=true"}},
                                      {"ida_2", "jon", {"station_keep"}},
                                      {"off", "all", {"park"}}}));
  EXPECT_NE(import.mission.find("RETURN_ALL=true: [[order]]: shoal send return\n"),
            std::string::npos);
  EXPECT_EQ(import.lost, std::vector<std::string>{});
}

TEST(ImportedOrders, AreMenuEntriesAndPokes) {
  const MoosImport import = WithButtons(
      "action = PATROL_ALL=true # PATROL_ALL=false\naction = menu_key=both # PATROL_IDA=1\n"
      "action+ = RETURN_IDA=true\n",
      {{.key = "upokedb", .label = "", .origins = "launch.sh:9", .posts = {{"PATROL_JON", "x"}}}});
  EXPECT_EQ(OrdersOf(import), (Orders{{"patrol_all_true", "all", {"set", "PATROL=true"}},
                                      {"patrol_all_false", "all", {"set", "PATROL=false"}},
                                      {"both", "ida", {"set", "PATROL=1"}},
                                      {"both", "ida", {"return"}},
                                      {"patrol_jon_x", "jon", {"set", "PATROL=x"}}}));
}

TEST(ImportedOrders, AreNoneForButtonsThatNoVehicleLooksAt) {
  const MoosImport import =
      WithButtons("button_one = NEXT # UTS_FORWARD=0\nbutton_two = GO # PATROL_ALL=$[UTC]\n");
  EXPECT_EQ(OrdersOf(import), Orders{});
  ASSERT_EQ(import.lost.size(), 2U);
  EXPECT_EQ(import.lost[0],
            "shore.moos:4: button_one = NEXT # UTS_FORWARD=0: it sets nothing that behaviors look "
            "at");
}

TEST(DeployButton, KeepsTheVariableStationKeepThatItDoesNotSet) {
  const auto keeps = [](const std::string& more) {
    const MoosImport import = WithButtons("button_one = DEPLOY # DEPLOY_ALL=true" + more + "\n");
    return LoadMissionText(import.mission, "m").mission.vehicles.at(0).helm_options.deploy_keeps;
  };
  EXPECT_EQ(keeps(""), std::vector<std::string>{"STATION_KEEP"});
  EXPECT_EQ(keeps(" # STATION_KEEP_ALL=false"), std::vector<std::string>{});
  EXPECT_EQ(LoadMissionText(WithButtons("").mission, "m")
                .mission.vehicles.at(0)
                .helm_options.deploy_keeps,
            std::vector<std::string>{})
      << "no button deploys";
}

}  // namespace shoal::import_orders_test
