#include "lib/bus/bus/layout.h"

#include <gtest/gtest.h>

#include <set>

#include "lib/bus/bus/channels.h"

namespace shoal::layout_test {

TEST(PortPlan, PutsTheShoreOnLcmsDefaultPort) {
  EXPECT_EQ(PortPlan(PortPlan::kDefaultBase, Layout::kShared, {"alpha"}).PortOf("NAV_ALPHA"), 7667);
}

TEST(PortPlan, CarriesAllDataOnOnePortWhenShared) {
  const PortPlan plan(8000, Layout::kShared, {"alpha", "bravo"});
  EXPECT_EQ(plan.DataPorts(), std::vector<int>{8002});
  EXPECT_EQ(plan.PortOf("NAV_BRAVO"), 8002);
  EXPECT_EQ(plan.PortOf("TICK"), 8000);
  EXPECT_EQ(plan.PortOf("STEP_DONE"), 8001);
}

TEST(PortPlan, GivesEachVehicleACommunity) {
  const PortPlan plan(8000, Layout::kCommunities, {"alpha", "bravo"});
  EXPECT_EQ(plan.PortOf("NAV_ALPHA"), 8003);
  EXPECT_EQ(plan.PortOf("HELM_COMMAND_BRAVO"), 8004);
  EXPECT_EQ(plan.PortOf("MY_OWN_THING_BRAVO"), 8004);
  EXPECT_EQ(plan.PortOf("NODE_REPORT_LOCAL"), 8002);
  EXPECT_EQ(plan.PortOf("HELM_COMMAND"), 8002);
  EXPECT_EQ(plan.PortOf("SOMETHING_ELSE"), 8002);
}

TEST(PortPlan, IsNotMisledByVehiclesNamedLikeTopics) {
  const PortPlan plan(8000, Layout::kCommunities, {"range", "report", "b", "a_b"});
  EXPECT_EQ(plan.PortOf("UNC_COMMS_RANGE"), 8002);
  EXPECT_EQ(plan.PortOf("NODE_REPORT"), 8002);
  EXPECT_EQ(plan.PortOf("NAV_RANGE"), 8003);
  EXPECT_EQ(plan.PortOf("NAV_A_B"), 8006);
  EXPECT_EQ(plan.PortOf("NAV_B"), 8005);
}

TEST(PortPlan, SharesCommunitiesAmongMoreVehiclesThanAProcessHasPortsFor) {
  std::vector<std::string> vehicles;
  for (int i = 0; i < 1000; ++i) vehicles.push_back("v" + std::to_string(i));
  const PortPlan plan(8000, Layout::kCommunities, vehicles);
  EXPECT_EQ(plan.DataPorts().size(), 1U + PortPlan::kMaxCommunities);
  EXPECT_EQ(plan.PortOf("NAV_V0"), plan.PortOf("NAV_V128"));
}

TEST(ChannelTable, NamesEachTopicOnceAtEachHome) {
  std::set<std::pair<std::string_view, ChannelHome>> rows;
  for (const ChannelRow& row : ChannelTable()) {
    EXPECT_TRUE(rows.emplace(row.topic, row.home).second) << row.topic;
  }
}

TEST(ChannelTable, FitsLcmsLimitWithTheLongestVehicleName) {
  for (const ChannelRow& row : ChannelTable()) EXPECT_LE(row.topic.size() + 1 + 32, 63U);
}

TEST(VehicleOfChannel, IsWhatFollowsTheTopic) {
  EXPECT_EQ(VehicleOfChannel("NAV_ALPHA", topics::kNav), "ALPHA");
  EXPECT_EQ(VehicleOfChannel(channels::NodeReport("my_boat").name, topics::kNodeReport), "MY_BOAT");
}

TEST(VehicleOfChannel, IsEmptyForOtherTopics) {
  EXPECT_EQ(VehicleOfChannel("NAV_ALPHA", topics::kDesired), "");
  EXPECT_EQ(VehicleOfChannel("MEASURED_NAV_ALPHA", topics::kNav), "");
  EXPECT_EQ(VehicleOfChannel("NAVY_ALPHA", topics::kNav), "");
  EXPECT_EQ(VehicleOfChannel("NAV", topics::kNav), "");
  EXPECT_EQ(VehicleOfChannel("NAV_", topics::kNav), "");
}

TEST(VehicleOfChannel, IsEmptyForChannelsOfTheShoreThatBeginWithTheTopic) {
  for (const ChannelRow& shore : ChannelTable()) {
    for (const ChannelRow& row : ChannelTable()) {
      EXPECT_EQ(VehicleOfChannel(shore.topic, row.topic), "") << shore.topic << ' ' << row.topic;
    }
  }
}

TEST(IsLogged, LeavesOutWhatIsMadeForDisplayAndStepping) {
  EXPECT_TRUE(IsLogged("NAV_ALPHA"));
  EXPECT_TRUE(IsLogged("MY_CAMERA"));
  EXPECT_FALSE(IsLogged("APPCAST"));
  EXPECT_FALSE(IsLogged("TICK"));
}

}  // namespace shoal::layout_test
