#include "lib/run/verdict/summary.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace shoal::summary_test {

Mission TwoVehicles() {
  Mission mission;
  mission.vehicles.resize(2);
  mission.vehicles[0].name = "alpha";
  mission.vehicles[1].name = "bravo";
  return mission;
}

void DeliverOne(Judge& judge) {
  judge.tally().fates(Kind::kReport).Add("alpha", "bravo", "delivered");
  judge.tally().fates(Kind::kReport).Add("alpha", "bravo", "out_of_range");
}

TEST(Summarize, ShowsVehiclesLinksAndVerdicts) {
  Mission mission = TwoVehicles();
  mission.expectations = {
      {.where = "a.toml:5", .what = CommsExpectation{.to = "bravo", .at_least = 1, .at_most = {}}}};
  Judge judge(mission);
  judge.TakeNav(0, {12.34, -5, 0});
  judge.TakeHelm(0, {.state = "DRIVE", .task = "home"}, 0);
  DeliverOne(judge);
  EXPECT_EQ(
      Summarize(mission, judge),
      "Vehicles\n"
      "    name             helm                            x_m        y_m   depth_m   "
      "travelled_m\n"
      "    alpha            DRIVE:home                     12.3       -5.0       0.0           "
      "0.0\n"
      "    bravo            (no helm)                (never seen)\n"
      "\n"
      "Reports delivered/offered\n"
      "    from \\ to                 alpha          bravo\n"
      "    alpha                         -            1/2\n"
      "    bravo                       0/0              -\n"
      "    all: 1/2, out_of_range 1\n"
      "\n"
      "Expectations\n"
      "    pass at least 1 reports delivered from all to bravo: 1 [a.toml:5]\n"
      "\n"
      "Warnings\n"
      "    no vehicle moved: none travelled 1 m\n"
      "    received no report of another vehicle: alpha\n"
      "\n"
      "PASS\n");
}

TEST(Summarize, ShowsMessagesAndAcksWhereThereWereAny) {
  const Mission mission = TwoVehicles();
  Judge judge(mission);
  judge.tally().fates(Kind::kMessage).Add("alpha", "bravo", "delivered");
  judge.tally().fates(Kind::kMessage).Add("alpha", "bravo", "too_soon");
  judge.tally().fates(Kind::kMessage).Add("alpha", "", "no_destination");
  const std::string summary = Summarize(mission, judge);
  EXPECT_NE(summary.find("    all: 0/0\n"
                         "\n"
                         "Messages delivered/offered\n"
                         "    from \\ to                 alpha          bravo\n"
                         "    alpha                         -            1/2\n"
                         "    bravo                       0/0              -\n"
                         "    all: 1/3, no_destination 1, too_soon 1\n"),
            std::string::npos)
      << summary;
  EXPECT_EQ(summary.find("Acks"), std::string::npos);
  EXPECT_EQ(summary.find("Packets"), std::string::npos);
  judge.tally().fates(Kind::kAck).Add("bravo", "alpha", "delivered");
  EXPECT_NE(Summarize(mission, judge).find("\n\nAcks delivered/offered\n"), std::string::npos);
  judge.tally().fates(Kind::kPacket).Add("bravo", "alpha", "collision");
  EXPECT_NE(Summarize(mission, judge).find("    all: 0/1, collision 1\n"), std::string::npos);
  EXPECT_NE(Summarize(mission, judge).find("\n\nPackets delivered/offered\n"), std::string::npos);
}

TEST(Summarize, EndsWithFailWhereAnExpectationWasMissed) {
  Mission mission = TwoVehicles();
  mission.expectations = {
      {.where = "a.toml:5", .what = CommsExpectation{.at_least = 2, .at_most = {}}},
      {.where = "a.toml:9", .what = CommsExpectation{.at_least = 0, .at_most = {}}}};
  Judge judge(mission);
  DeliverOne(judge);
  const std::string summary = Summarize(mission, judge);
  EXPECT_NE(summary.find("FAIL at least 2 reports delivered from all to all: 1, 1 too few"),
            std::string::npos);
  EXPECT_TRUE(summary.ends_with("\nFAIL: 1 of 2 expectations missed\n"));
}

TEST(Summarize, ShowsCollisionsAndFailsByThemWhereTheyAreNotAllowed) {
  Mission mission = TwoVehicles();
  Judge judge(mission);
  judge.TakeNav(0, {0, 0, 0});
  judge.TakeNav(1, {2.5, 0, 0});
  judge.EndStep(75'900'000);
  const std::string row = "    alpha and bravo at 75.9 s: 2.50 m, less than 3.00 m\n";
  EXPECT_NE(
      Summarize(mission, judge)
          .find("\nCollisions: the mission fails, unless [mission] collisions = \"allowed\"\n" +
                row),
      std::string::npos);
  EXPECT_TRUE(Summarize(mission, judge).ends_with("\nFAIL: 1 collision\n"));
  EXPECT_NE(Summarize(mission, judge, false).find(row), std::string::npos);

  mission.expectations = {
      {.where = "a.toml:5", .what = CommsExpectation{.at_least = 2, .at_most = {}}}};
  Judge strict(mission);
  strict.TakeNav(0, {0, 0, 0});
  strict.TakeNav(1, {2.5, 0, 0});
  strict.EndStep(0);
  EXPECT_TRUE(
      Summarize(mission, strict).ends_with("\nFAIL: 1 of 1 expectations missed, 1 collision\n"));

  mission.expectations.clear();
  mission.collisions = CollisionVerdict::kAllowed;
  EXPECT_NE(Summarize(mission, judge).find("\nCollisions: allowed by [mission] collisions\n" + row),
            std::string::npos);
  EXPECT_TRUE(Summarize(mission, judge).ends_with("\nPASS\n"));
}

TEST(Summarize, ListsSentAndReceivedWhereAMatrixWouldBeTooWide) {
  Mission mission = TwoVehicles();
  mission.vehicles.resize(100);
  for (size_t i = 2; i < 100; ++i) mission.vehicles[i].name = fmt::format("v{}", i);
  Judge judge(mission);
  DeliverOne(judge);
  const std::string summary = Summarize(mission, judge);
  EXPECT_NE(summary.find("alpha                             1/2                  0/0\n"),
            std::string::npos)
      << summary;
  EXPECT_NE(summary.find("bravo                             0/0                  1/2\n"),
            std::string::npos);
  EXPECT_NE(summary.find("(and 40 more)"), std::string::npos);
}

}  // namespace shoal::summary_test
