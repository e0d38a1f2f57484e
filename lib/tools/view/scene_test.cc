#include "lib/tools/view/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "lib/tools/view/view_testing.h"

namespace shoal::scene_test {

/// Counts the calls with the expected values.
struct Witness : SceneObserver {
  void OnNav(size_t vehicle, const nav_t& nav) override {
    num_navs += vehicle == 1 && nav.x_m == 5;
  }
  void OnHelm(size_t vehicle, const helm_state_t& helm) override {
    num_helms += vehicle == 0 && helm.state == "DRIVE";
  }
  void OnReport(size_t vehicle, const ReceivedReport& report) override {
    num_reports += vehicle == 0 && report.x_m == 1;
  }
  void OnFate(const FateView& fate, const LinkPlace& place) override {
    num_fates += fate.source == "alpha" && place.from == 0 && place.to == 1 && place.link == 0;
  }
  int num_navs = 0, num_helms = 0, num_reports = 0, num_fates = 0;
};

class SceneTest : public testing::Test {
 protected:
  template <class T>
  void Handle(const std::string& channel, const T& message, SceneObserver* observer = nullptr) {
    scene_.Handle(channel, Encoded(message), observer);
  }

  Scene scene_{MissionOf({"alpha", "Bravo"})};
};

TEST_F(SceneTest, BeginsWithTheMissionsVehiclesAndRules) {
  ASSERT_EQ(scene_.vehicles().size(), 2U);
  EXPECT_EQ(scene_.vehicles()[1].name, "Bravo");
  EXPECT_EQ(scene_.vehicles()[1].color, "yellow");
  EXPECT_FALSE(scene_.vehicles()[1].nav);
  ASSERT_TRUE(scene_.rules());
  EXPECT_EQ(scene_.rules()->comms_range_m, 100);
  scene_.ForgetRules();
  EXPECT_FALSE(scene_.rules());
}

TEST_F(SceneTest, TakesWhatVehiclesPublish) {
  Witness witness;
  Handle("NAV_BRAVO", NavAt(3 * kSecond_us, 5, 6), &witness);
  helm_state_t helm{};
  helm.utime = 3 * kSecond_us;
  helm.state = "DRIVE";
  helm.task = std::string(1'000'000, 't');
  Handle("HELM_STATE_ALPHA", helm, &witness);
  desired_t desired{};
  desired.heading_deg = 90;
  desired.utime = 3 * kSecond_us;
  Handle("DESIRED_ALPHA", desired);
  swarm_t swarm{};
  swarm.utime = 3 * kSecond_us;
  swarm.num_said = 14;
  Handle("SWARM_ALPHA", swarm);
  ASSERT_TRUE(scene_.vehicles()[1].nav);
  EXPECT_EQ(scene_.vehicles()[1].nav->y_m, 6);
  ASSERT_TRUE(scene_.vehicles()[0].helm);
  EXPECT_EQ(scene_.vehicles()[0].helm->task.size(), Scene::kMaxText);
  EXPECT_EQ(LastOf<ShownDesired>(scene_.vehicles()[0].shown)->heading_deg, 90);
  EXPECT_EQ(scene_.vehicles()[0].swarm->num_said, 14);
  EXPECT_EQ(scene_.now_s(), 3);
  EXPECT_EQ(witness.num_navs, 1);
  EXPECT_EQ(witness.num_helms, 1);
  EXPECT_EQ(scene_.num_undecodable(), 0);
}

TEST_F(SceneTest, IgnoresUnknownChannelsAndCountsBytesThatDoNotDecode) {
  Handle("NAV_CHARLIE", NavAt(0, 1, 1));
  scene_.Handle("", {});
  EXPECT_EQ(scene_.num_undecodable(), 0);
  scene_.Handle("NAV_ALPHA", {});
  Handle("NAV_ALPHA", desired_t{});
  EXPECT_EQ(scene_.num_undecodable(), 2);
  EXPECT_FALSE(scene_.vehicles()[0].nav);
}

TEST_F(SceneTest, KnowsReportsAsTheBrokerReceivesThem) {
  Witness witness;
  Handle("NAV_ALPHA", NavAt(7 * kSecond_us, 0, 0));
  Handle("NODE_REPORT_LOCAL", ReportOf("ALPHA", 6'500'000, 1, 2), &witness);
  ASSERT_TRUE(scene_.vehicles()[0].report);
  EXPECT_EQ(scene_.vehicles()[0].report->utime, 6'500'000);
  EXPECT_EQ(scene_.vehicles()[0].report->received_utime, 7 * kSecond_us);
  EXPECT_EQ(scene_.vehicles()[0].report->mode, "DRIVE survey");
  EXPECT_EQ(witness.num_reports, 1);
  node_report_t impossible = ReportOf("alpha", 8 * kSecond_us, 9, 9);
  impossible.altitude_m = std::numeric_limits<double>::quiet_NaN();
  Handle("NODE_REPORT_LOCAL", impossible);
  EXPECT_EQ(scene_.vehicles()[0].report->x_m, 1) << "the broker refuses such a report";
}

TEST_F(SceneTest, AddsVehiclesFromOutsideUntilThereAreTooMany) {
  for (int i = 0; i < 300; ++i) {
    Handle("NODE_REPORT", ReportOf("out" + std::to_string(i), 0, i, 0));
  }
  Handle("NODE_REPORT", ReportOf("no legal name", 0, 0, 0));
  Handle("NODE_REPORT", ReportOf(std::string(1'000'000, 'x'), 0, 0, 0));
  EXPECT_EQ(scene_.vehicles().size(), 2 + Scene::kMaxOutside);
  EXPECT_EQ(scene_.num_left_out(), 100);
  EXPECT_EQ(scene_.num_undecodable(), 2);
  EXPECT_TRUE(scene_.vehicles()[2].outside);
  EXPECT_FALSE(scene_.vehicles()[0].outside);
  ASSERT_NE(scene_.Find("OUT7"), nullptr);
  EXPECT_EQ(scene_.Find("OUT7")->report->x_m, 7);
  EXPECT_EQ(scene_.Find("out299"), nullptr);
}

TEST_F(SceneTest, CountsAsStaleWhatTheBrokerCountsAsStale) {
  Handle("COMMS_RULES", ToMessage(RulesWith(0, 100, 5)));
  EXPECT_FALSE(scene_.IsStale(scene_.vehicles()[0])) << "it has never reported";
  Handle("NODE_REPORT_LOCAL", ReportOf("alpha", 0, 0, 0));
  Handle("NAV_ALPHA", NavAt(4'999'999, 0, 0));
  EXPECT_FALSE(scene_.IsStale(scene_.vehicles()[0]));
  Handle("NAV_ALPHA", NavAt(5'000'000, 0, 0));
  EXPECT_TRUE(scene_.IsStale(scene_.vehicles()[0]));
  Handle("COMMS_RULES", ToMessage(RulesWith(5'000'000, 100, -1)));
  EXPECT_FALSE(scene_.IsStale(scene_.vehicles()[0])) << "no vehicle becomes stale";
}

TEST_F(SceneTest, TakesTheRulesThatTheBrokerPublishes) {
  BrokerRules rules = RulesWith(0, -1, 8);
  rules.rules.drop_percentage = 12.5;
  rules.factors = {{"alpha", {.stealth = 0.5, .earange = 2}}};
  Handle("COMMS_RULES", ToMessage(rules));
  EXPECT_EQ(scene_.rules()->comms_range_m, -1);
  EXPECT_EQ(scene_.rules()->drop_percentage, 12.5);
  ASSERT_EQ(scene_.rules()->factors.size(), 1U);
  EXPECT_EQ(scene_.rules()->factors[0].second, (LinkFactors{.stealth = 0.5, .earange = 2}));
}

TEST_F(SceneTest, CountsFatesAndKeepsPackets) {
  Witness witness;
  Handle("NAV_ALPHA", NavAt(kSecond_us, 1, -3));
  Handle("COMMS_FATES",
         FatesOf(2 * kSecond_us, {FateOf("alpha", "Bravo", "delivered"),
                                  Through(FateOf("alpha", "bravo", "packet_loss"), CalmPath(0))}),
         &witness);
  EXPECT_EQ(scene_.links().num_fates(), 2);
  EXPECT_EQ(witness.num_fates, 2);
  EXPECT_EQ(scene_.now_s(), 2);
  const auto packets = scene_.packets().Since(0, scene_.now_utime());
  ASSERT_EQ(packets.size(), 1U);
  EXPECT_EQ(packets[0]->from_m, std::pair(1.0, -3.0));
}

TEST_F(SceneTest, MovesTimeForwardAndBackOnlyByALongWay) {
  Handle("NAV_ALPHA", NavAt(10 * kSecond_us, 0, 0));
  Handle("NAV_BRAVO", NavAt(9'900'000, 0, 0));
  EXPECT_EQ(scene_.now_s(), 10) << "messages of a step may overtake one another";
  Handle("NAV_BRAVO", NavAt(std::numeric_limits<int64_t>::max(), 0, 0));
  Handle("NAV_BRAVO", NavAt(std::numeric_limits<int64_t>::min(), 0, 0));
  Handle("NAV_ALPHA", NavAt(10'100'000, 0, 0));
  EXPECT_EQ(scene_.now_s(), 10.1) << "one liar does not stop the clock";
  clock_state_t clock{};
  clock.utime = 20 * kSecond_us;
  clock.step = -1;
  scene_.HandleClock(clock);
  EXPECT_EQ(scene_.now_s(), 10.1) << "it has not begun";
  clock.step = 200;
  scene_.HandleClock(clock);
  EXPECT_EQ(scene_.now_s(), 20);
}

TEST_F(SceneTest, CountsTimeFromTheMissionsStart) {
  Mission mission = MissionOf({"alpha"});
  mission.start_utime = 1'000'000 * kSecond_us;
  Scene scene(mission);
  EXPECT_EQ(scene.now_s(), 0);
  scene.Handle("NAV_ALPHA", Encoded(NavAt(1'000'007 * kSecond_us, 0, 0)));
  EXPECT_EQ(scene.now_s(), 7);
}

TEST_F(SceneTest, IsCopiedByValue) {
  Handle("NAV_ALPHA", NavAt(kSecond_us, 1, 1));
  Scene copy = scene_;
  Handle("NAV_ALPHA", NavAt(2 * kSecond_us, 2, 2));
  copy.Handle("NODE_REPORT", Encoded(ReportOf("visitor", 0, 0, 0)));
  EXPECT_EQ(copy.vehicles()[0].nav->x_m, 1);
  EXPECT_EQ(copy.vehicles().size(), 3U);
  EXPECT_EQ(scene_.vehicles().size(), 2U);
}

TEST(SceneChannels, AreThoseToWhichItSubscribes) {
  std::vector<std::string> expected = {"COMMS_FATES",        "COMMS_MEDIA",       "COMMS_RULES",
                                       "HELM_COMMAND_ALPHA", "HELM_STATE_ALPHA",  "NAV_ALPHA",
                                       "NODE_REPORT",        "NODE_REPORT_LOCAL", "SWARM_ALPHA",
                                       "VIEW_CIRCLE",        "VIEW_COMMS_PULSE",  "VIEW_POINT",
                                       "VIEW_POLYGON",       "VIEW_SEGLIST",      "VIEW_TEXT"};
  ForEachShownChannel(
      [&]<class Row, size_t kRow>() { expected.push_back(Row::ChannelOf("alpha").name); });
  std::sort(expected.begin(), expected.end());
  EXPECT_NE(std::find(expected.begin(), expected.end(), "DESIRED_ALPHA"), expected.end());
  EXPECT_EQ(Scene::Channels(MissionOf({"alpha"})), expected);
}

}  // namespace shoal::scene_test
