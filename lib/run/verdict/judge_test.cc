#include "lib/run/verdict/judge.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include "lib/run/verdict/summary.h"

namespace shoal::judge_test {

constexpr int64_t kStart = 5'000'000;

int64_t At(double seconds) { return kStart + static_cast<int64_t>(seconds * 1e6); }

Mission TwoVehicles(const decltype(Expectation::what)& what) {
  Mission mission;
  mission.start_utime = kStart;
  mission.duration_s = 900;
  mission.vehicles.resize(2);
  mission.vehicles[0].name = "alpha";
  mission.vehicles[1].name = "Bravo";
  mission.vehicles[1].return_task.point_m = {100, 0};
  mission.expectations = {{.where = "berta.toml:88", .what = what}};
  return mission;
}

class JudgeTest : public testing::Test {
 protected:
  Judge& For(const decltype(Expectation::what)& what) {
    mission_ = TwoVehicles(what);
    return judge_.emplace(mission_);
  }
  ExpectationVerdict Only() const { return judge_->Verdicts().at(0); }

  Mission mission_;
  std::optional<Judge> judge_;
};

TEST_F(JudgeTest, StatesWhereAndWhatWasExpected) {
  For(SeparationExpectation{.min_m = 5});
  EXPECT_EQ(Only().where, "berta.toml:88");
  EXPECT_EQ(Only().text, "no two vehicles closer than 5 m");
}

TEST_F(JudgeTest, PassesASeparationJustKept) {
  Judge& judge = For(SeparationExpectation{.min_m = 5});
  judge.TakeNav(0, {0, 0, 0});
  judge.TakeNav(1, {3, 4, 0});
  judge.EndStep(At(212.4));
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().numbers, "closest: alpha-Bravo 5.0 m at 212.4 s");
}

TEST_F(JudgeTest, FailsASeparationJustBroken) {
  Judge& judge = For(SeparationExpectation{.min_m = 5});
  judge.TakeNav(0, {0, 0, 0});
  judge.TakeNav(1, {4.99, 0, 0});
  judge.EndStep(At(1));
  judge.TakeNav(1, {400, 0, 0});
  judge.EndStep(At(2));
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "closest: alpha-Bravo 5.0 m at 1.0 s, 0.01 m too close");
}

TEST_F(JudgeTest, DoesNotPassASeparationThatWasNeverMeasured) {
  For(SeparationExpectation{.min_m = 5}).TakeNav(0, {0, 0, 0});
  judge_->EndStep(At(1));
  EXPECT_FALSE(Only().passed);
}

TEST_F(JudgeTest, IgnoresPositionsThatAreNone) {
  Judge& judge = For(SeparationExpectation{.min_m = 5});
  EXPECT_TRUE(judge.TakeNav(0, {0, 0, 0}));
  EXPECT_FALSE(judge.TakeNav(1, {std::numeric_limits<double>::quiet_NaN(), 0, 0}));
  judge.EndStep(At(1));
  EXPECT_EQ(Only().numbers, "no two vehicles were seen");
}

TEST_F(JudgeTest, StatesHowMuchOfAnAreaWasCovered) {
  Judge& judge = For(CoverageExpectation{.polygon_m = {{0, 0}, {400, 0}, {400, 100}, {0, 100}},
                                         .sensor_width_m = 20,
                                         .at_least_pct = 25,
                                         .vehicles = {"alpha"}});
  EXPECT_EQ(Only().text, "at least 25 % of the polygon covered 20 m wide by alpha");
  for (int i = 0; i <= 250; ++i) {
    judge.TakeNav(0, {2.0 * i - 50, 50, 0});
    judge.TakeNav(1, {2.0 * i - 50, 20, 0});  // Of a vehicle that does not count.
    judge.EndStep(At(i));
  }
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers.find("20.0"), 0U) << Only().numbers;
  EXPECT_NE(Only().numbers.find(" m2, in cells of 1 m, 5.0 % too low"), std::string::npos)
      << Only().numbers;
  for (int i = 0; i <= 250; ++i) {
    judge.TakeNav(0, {2.0 * i - 50, 80, 0});
    judge.EndStep(At(600 + i));
  }
  EXPECT_TRUE(Only().passed);
}

TEST_F(JudgeTest, MeasuresTheWayOfEachVehicle) {
  Judge& judge = For(SeparationExpectation{.min_m = 5});
  judge.TakeNav(0, {10, 10, 0});
  judge.TakeNav(0, {13, 14, 0});
  judge.TakeNav(0, {13, 14, 2});
  EXPECT_EQ(judge.travelled_m(0), 7);
  EXPECT_EQ(judge.travelled_m(1), 0);
}

TEST_F(JudgeTest, WantsEveryVehicleAtItsReturnPoint) {
  Judge& judge =
      For(ArrivalExpectation{.vehicle = "all", .point_m = {}, .within_m = 20, .by_s = 600});
  judge.TakeNav(0, {20, 0, 0});
  judge.TakeNav(1, {80, 0, 0});
  judge.EndStep(At(599));
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "every vehicle within 20 m of its return point by 600 s");
}

TEST_F(JudgeTest, NamesTheVehicleThatDidNotArrive) {
  Judge& judge =
      For(ArrivalExpectation{.vehicle = "all", .point_m = {}, .within_m = 20, .by_s = 600});
  judge.TakeNav(0, {20, 0, 0});
  judge.TakeNav(1, {75, 0, 0});
  judge.EndStep(At(599));
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "1 of 2 failed: Bravo: closest: 25.0 m at 599.0 s, 5.0 m too far");
}

TEST_F(JudgeTest, NamesEachVehicleThatDidNotArrive) {
  Judge& judge =
      For(ArrivalExpectation{.vehicle = "all", .point_m = {}, .within_m = 20, .by_s = 600});
  judge.TakeNav(0, {30, 0, 0});
  judge.EndStep(At(599));
  EXPECT_EQ(Only().numbers,
            "2 of 2 failed: alpha: closest: 30.0 m at 599.0 s, 10.0 m too far; Bravo: never seen");
}

TEST_F(JudgeTest, NamesTheNarrowestOfMany) {
  Judge& judge =
      For(ArrivalExpectation{.vehicle = "all", .point_m = {}, .within_m = 20, .by_s = 600});
  judge.TakeNav(0, {0, 0, 0});
  judge.EndStep(At(100));
  judge.TakeNav(1, {100, 0, 0});
  judge.EndStep(At(200));
  EXPECT_EQ(Only().numbers, "all 2; narrowest Bravo: there at 200.0 s");
}

TEST_F(JudgeTest, TakesAGivenPointAndTheMissionsEndAsDefaultLimit) {
  Judge& judge = For(ArrivalExpectation{
      .vehicle = "BRAVO", .point_m = Eigen::Vector2d(0, 50), .within_m = 1, .by_s = 0});
  EXPECT_EQ(Only().text, "BRAVO within 1 m of (0, 50) by 900 s");
  judge.TakeNav(1, {0, 49, 30});
  judge.EndStep(At(900));
  EXPECT_TRUE(Only().passed);
}

TEST_F(JudgeTest, CountsReportsOfOneLink) {
  Judge& judge =
      For(CommsExpectation{.from = "alpha", .to = "bravo", .at_least = 2, .at_most = {}});
  judge.tally().fates(Kind::kReport).Add("alpha", "Bravo", "delivered");
  judge.tally().fates(Kind::kReport).Add("Bravo", "alpha", "delivered");
  judge.tally().fates(Kind::kReport).Add("alpha", "Bravo", "out_of_range");
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "1, 1 too few");
  judge.tally().fates(Kind::kReport).Add("alpha", "Bravo", "delivered");
  EXPECT_TRUE(Only().passed);
}

TEST_F(JudgeTest, CountsReportsOfAllLinksAndOneCause) {
  Judge& judge = For(CommsExpectation{.cause = "out_of_range", .at_least = {}, .at_most = 1});
  judge.tally().fates(Kind::kReport).Add("alpha", "Bravo", "out_of_range");
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "at most 1 reports out_of_range from all to all");
  judge.tally().fates(Kind::kReport).Add("nemo", "alpha", "out_of_range");
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "2, 1 too many");
}

TEST_F(JudgeTest, DistinguishesReportsMessagesAndAcks) {
  Judge& judge = For(CommsExpectation{.kind = Kind::kMessage, .at_least = 3, .at_most = {}});
  EXPECT_EQ(Only().text, "at least 3 messages delivered from all to all");
  judge.tally().fates(Kind::kReport).Add("alpha", "Bravo", "delivered", 10);
  judge.tally().fates(Kind::kAck).Add("alpha", "Bravo", "delivered", 10);
  judge.tally().fates(Kind::kMessage).Add("alpha", "Bravo", "delivered", 2);
  EXPECT_EQ(Only().numbers, "2, 1 too few");
  judge.tally().fates(Kind::kMessage).Add("Bravo", "alpha", "delivered");
  EXPECT_TRUE(Only().passed);
}

TEST_F(JudgeTest, JudgesTheShareOfPacketsOfOneLink) {
  CommsExpectation share{.kind = Kind::kPacket, .from = "alpha", .to = "bravo"};
  share.at_least_pct = 70;
  share.at_most_pct = 90;
  Judge& judge = For(share);
  EXPECT_EQ(Only().text, "at least 70 % and at most 90 % of packets delivered from alpha to bravo");
  FateCounts& fates = judge.tally().fates(Kind::kPacket);
  judge.tally().fates(Kind::kReport).Add("alpha", "Bravo", "delivered", 100);
  fates.Add("Bravo", "alpha", "delivered", 100);
  fates.Add("alpha", "Bravo", "collision", 2);
  fates.Add("alpha", "Bravo", "packet_loss");
  fates.Add("alpha", "Bravo", "delivered", 6);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "6 of 9 (66.67 %), 3.3 % too low");
  fates.Add("alpha", "Bravo", "delivered");
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().numbers, "7 of 10 (70 %)");
  fates.Add("alpha", "Bravo", "delivered", 20);
  EXPECT_TRUE(Only().passed) << "exactly 90 %";
  fates.Add("alpha", "Bravo", "delivered", 20);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "47 of 50 (94 %), 4.0 % too high");
}

TEST_F(JudgeTest, TakesAShareThatIsExactlyTheLimitForWithin) {
  CommsExpectation share{.kind = Kind::kPacket};
  share.at_least_pct = 0.07;
  share.at_most_pct = 0.07;
  Judge& judge = For(share);
  judge.tally().fates(Kind::kPacket).Add("alpha", "bravo", "delivered", 7);
  judge.tally().fates(Kind::kPacket).Add("alpha", "bravo", "collision", 9993);
  EXPECT_TRUE(Only().passed) << Only().numbers;
  judge.tally().fates(Kind::kPacket).Add("alpha", "bravo", "collision");
  EXPECT_FALSE(Only().passed) << Only().numbers;
}

TEST_F(JudgeTest, WantsTheCountAndTheShare) {
  CommsExpectation both{.at_least = 10, .at_most = {}};
  both.at_least_pct = 50;
  Judge& judge = For(both);
  EXPECT_EQ(Only().text, "at least 10 and at least 50 % of reports delivered from all to all");
  judge.tally().fates(Kind::kReport).Add("alpha", "bravo", "delivered", 9);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "9 of 9 (100 %), 1 too few");
  judge.tally().fates(Kind::kReport).Add("alpha", "bravo", "packet_loss", 11);
  EXPECT_EQ(Only().numbers, "9 of 20 (45 %), 5.0 % too low, 1 too few");
}

TEST_F(JudgeTest, FailsAtLeastAShareOfNothing) {
  CommsExpectation low;
  low.at_least_pct = 0;
  For(low);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "nothing was offered on these links");
  CommsExpectation high;
  high.at_most_pct = 0;
  For(high);
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "at most 0 % of reports delivered from all to all");
  EXPECT_EQ(Only().numbers, "nothing was offered on these links");
}

TEST_F(JudgeTest, CountsDestinationsGivenTogetherForAllAndForNone) {
  Judge& judge =
      For(CommsExpectation{.to = "bravo", .cause = "out_of_range", .at_least = {}, .at_most = 0});
  judge.tally().fates(Kind::kReport).Add("alpha", "*", "out_of_range", 998);
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(judge.tally().fates(Kind::kReport).Count(0, FateCounts::kAll, "out_of_range"), 998);
}

TEST_F(JudgeTest, ComparesTheHelmsLastStateAndTask) {
  Judge& judge = For(HelmExpectation{.vehicle = "alpha", .state = "DRIVE", .task = "home"});
  EXPECT_EQ(Only().numbers, "no helm state was received");
  judge.TakeHelm(0, {.state = "DRIVE", .task = "home"}, At(1));
  EXPECT_TRUE(Only().passed);
  judge.TakeHelm(0, {.state = "DRIVE", .task = "survey"}, At(2));
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "DRIVE with task survey");
  judge.TakeHelm(0, {.state = "PARK", .task = ""}, At(3));
  EXPECT_EQ(Only().numbers, "PARK with no task");
}

TEST_F(JudgeTest, CountsTheLapsOfATaskUntilItsLimit) {
  const LapsExpectation expected = {
      .vehicle = "alpha", .task = "survey", .at_least = 2, .by_s = 300};
  Judge& judge = For(expected);
  judge.TakeHelm(1, {.state = "DRIVE", .task = "survey", .laps_done = 5}, At(10));
  judge.TakeHelm(0, {.state = "DRIVE", .task = "loiter", .laps_done = 5}, At(10));
  judge.TakeHelm(0, {.state = "DRIVE", .task = "survey", .laps_done = 1}, At(150));
  EXPECT_EQ(Only().numbers, "1, 1 too few");
  judge.TakeHelm(0, {.state = "DRIVE", .task = "survey", .laps_done = 2}, At(300));
  judge.TakeHelm(0, {.state = "DRIVE", .task = "home", .laps_done = 0}, At(301));
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().numbers, "2, enough at 300.0 s");

  For(expected).TakeHelm(0, {.state = "DRIVE", .task = "survey", .laps_done = 2}, At(300.1));
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "2, enough at 300.1 s, 0.1 s late");
}

TEST_F(JudgeTest, ListsOnlySomeOfManyFailures) {
  mission_ = TwoVehicles(HelmExpectation{.vehicle = "all", .state = "PARK", .task = ""});
  mission_.vehicles.resize(20, mission_.vehicles[0]);
  for (size_t i = 0; i < 20; ++i) mission_.vehicles[i].name = fmt::format("v{}", i);
  judge_.emplace(mission_);
  EXPECT_NE(Only().numbers.find("20 of 20 failed: v0: "), std::string::npos);
  EXPECT_NE(Only().numbers.find("; and 15 more"), std::string::npos);
}

/// Two vehicles `distance_m` apart in a step at `time_s`.
void Meet(Judge* judge, double distance_m, double time_s) {
  judge->TakeNav(0, {0, 0, 0});
  judge->TakeNav(1, {distance_m, 0, 0});
  judge->EndStep(At(time_s));
}

TEST_F(JudgeTest, FailsAMissionWithACollisionUnlessItAllowsThem) {
  Judge& judge = For(SeparationExpectation{.min_m = 1});
  Meet(&judge, 3, 1);
  EXPECT_TRUE(judge.Passed()) << "the mean of their lengths is not nearer than itself";
  Meet(&judge, 2.9, 2);
  Meet(&judge, 2.8, 3);
  ASSERT_EQ(judge.num_collisions(), 1);
  EXPECT_EQ(judge.collisions().at(0).time_s, 2);
  EXPECT_DOUBLE_EQ(judge.collisions().at(0).collision.range_m, 2.9);
  EXPECT_FALSE(judge.Passed());
  mission_.collisions = CollisionVerdict::kAllowed;
  EXPECT_TRUE(judge.Passed());
}

TEST_F(JudgeTest, FailsAMissionWhereAVehicleHitsAnObstacle) {
  mission_ = TwoVehicles(SeparationExpectation{.min_m = 0});
  mission_.obstacles = {{"rock", {{10, -5}, {20, -5}, {20, 5}, {10, 5}}}};
  Judge& judge = judge_.emplace(mission_);
  Meet(&judge, 100, 1);
  EXPECT_TRUE(judge.Passed());
  judge.TakeNav(0, {9, 0, 0});
  judge.EndStep(At(2));
  ASSERT_EQ(judge.num_collisions(), 1);
  EXPECT_TRUE(judge.collisions().at(0).is_obstacle);
  EXPECT_FALSE(judge.Passed());
  EXPECT_NE(Summarize(mission_, judge).find("and obstacle rock at 2.0 s: 1.00 m, less than 1.50 m"),
            std::string::npos)
      << Summarize(mission_, judge);
}

/// The floor is flat, at 5 m; alpha is what `model` makes it.
class Grounding : public JudgeTest {
 protected:
  Judge& With(const AnyModel& model) {
    mission_ = TwoVehicles(SeparationExpectation{.min_m = 0});
    mission_.environment.floor.style = "flat";
    mission_.environment.floor.depth_m = 5;
    mission_.environment.floor.range_m = 0;
    mission_.vehicles[0].model = model;
    return judge_.emplace(mission_);
  }
  void AlphaAt(double depth_m, double time_s) {
    judge_->TakeNav(0, {7, -2, depth_m});
    judge_->TakeNav(1, {1000, 0, 0});
    judge_->EndStep(At(time_s));
  }
  bool Has(const std::string& text) const {
    return Summarize(mission_, *judge_).find(text) != std::string::npos;
  }
};

TEST_F(Grounding, FailsTheMissionUnlessItAllowsIt) {
  Judge& judge = With(Remus100Options());
  AlphaAt(4.9, 1);
  EXPECT_TRUE(judge.Passed()) << "afloat";
  AlphaAt(5.2, 2);
  AlphaAt(5.3, 3);
  ASSERT_EQ(judge.num_groundings(), 1) << "once, while it lies there";
  EXPECT_FALSE(judge.Passed());
  EXPECT_TRUE(
      Has("\nAground: the mission fails, unless [mission] grounding = \"allowed\"\n"
          "    alpha ran aground at 2.0 s at (7.0, -2.0): 5.2 m deep, the floor at 5.0 m\n"))
      << Summarize(mission_, judge);
  EXPECT_TRUE(Has("\nFAIL: 1 grounding\n"));
  mission_.grounding = GroundingVerdict::kAllowed;
  EXPECT_TRUE(judge.Passed());
  EXPECT_TRUE(Has("\nAground: allowed by [mission] grounding\n"));
  EXPECT_TRUE(Has("\nPASS\n"));
}

TEST_F(Grounding, OfASurfaceCraftIsWhereItsDraughtIsMoreThanTheWater) {
  Judge& judge = With(SurfaceCraftParams());
  AlphaAt(0, 1);
  EXPECT_EQ(judge.num_groundings(), 0);
  mission_.vehicles[0].draught_m = 5;
  AlphaAt(0, 2);
  EXPECT_EQ(judge.num_groundings(), 1);
  EXPECT_TRUE(Has("(7.0, -2.0): draught 5 m, the floor at 5.0 m\n"));
}

TEST_F(Grounding, IsNoneOfABuoyAndAWarningOfARecordedTrack) {
  Judge& buoy = With(BuoyParams());
  mission_.vehicles[0].draught_m = 9;
  AlphaAt(0, 1);
  EXPECT_EQ(buoy.num_groundings(), 0);
  Judge& track = With(TrackOptions());
  mission_.vehicles[0].draught_m = 9;
  AlphaAt(0, 1);
  EXPECT_EQ(track.num_groundings(), 0);
  EXPECT_TRUE(track.Passed());
  EXPECT_TRUE(Has("into the floor, of the mission's map: alpha\n"));
}

TEST_F(Grounding, IsNoneWhereTheDepthIsNotKnown) {
  Judge& judge = For(SeparationExpectation{.min_m = 0});
  AlphaAt(10'000, 1);
  EXPECT_EQ(judge.num_groundings(), 0);
}

TEST_F(JudgeTest, ComparesPositionsOfOneStepOnly) {
  Judge& judge = For(SeparationExpectation{.min_m = 1});
  judge.TakeNav(0, {0, 0, 0});
  judge.EndStep(At(1));
  judge.TakeNav(1, {1, 0, 0});
  judge.EndStep(At(2));
  EXPECT_EQ(judge.num_collisions(), 0);
}

TEST_F(JudgeTest, CountsMoreCollisionsThanItKeeps) {
  Judge& judge = For(SeparationExpectation{.min_m = 0});
  const int64_t most = Judge::kMaxCollisions;
  for (int64_t i = 0; i < most + 1; ++i) {
    Meet(&judge, 1, static_cast<double>(i));
    Meet(&judge, 100, static_cast<double>(i));
  }
  EXPECT_EQ(judge.num_collisions(), most + 1);
  EXPECT_EQ(judge.collisions().size(), Judge::kMaxCollisions);
}

using Warnings = std::vector<std::string>;

TEST_F(JudgeTest, WarnsWhereNoVehicleWasDeployed) {
  Judge& judge = For(CommsExpectation{});
  judge.tally().fates(Kind::kReport).Add("alpha", "bravo", "delivered");
  judge.tally().fates(Kind::kReport).Add("bravo", "alpha", "delivered");
  Meet(&judge, 100, 0);
  judge.TakeHelm(0, {.state = "PARK", .task = ""}, At(0));
  EXPECT_EQ(judge.Warnings(), Warnings{"no vehicle was deployed: every helm stayed in PARK"});
  mission_.participants = {{.name = "planner", .command = {}}};
  EXPECT_EQ(judge.Warnings(), Warnings{}) << "a program of the user may leave them where they are";
  mission_.participants.clear();
  judge.TakeHelm(0, {.state = "DRIVE", .task = "way"}, At(1));
  judge.TakeHelm(0, {.state = "PARK", .task = ""}, At(2));
  EXPECT_EQ(judge.Warnings(), Warnings{"no vehicle moved: none travelled 1 m"});
  Meet(&judge, 101, 3);
  EXPECT_EQ(judge.Warnings(), Warnings{});
}

TEST(JudgeWarnings, NameVehiclesThatLeftTheGridOfTheCurrent) {
  Mission mission = TwoVehicles(CommsExpectation{});
  mission.file = testing::TempDir() + "judge_test_grid.toml";
  mission.environment.current_grid.east = "judge_test_grid.asc";
  mission.environment.current_grid.north = "judge_test_grid.asc";
  std::ofstream(testing::TempDir() + "judge_test_grid.asc")
      << "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 10\n0 0\n0 0\n";
  Judge judge(mission);
  EXPECT_TRUE(judge.TakeNav(0, {14, 14, 0}, -1));
  EXPECT_TRUE(judge.TakeNav(1, {16, 5, 0}, -1));
  EXPECT_TRUE(judge.TakeNav(1, {5, 5, 0}, -1));
  const Warnings warnings = judge.Warnings();
  EXPECT_EQ(std::ranges::count(warnings,
                               "left the grid of the current, and had the water of its "
                               "nearest edge: Bravo"),
            1);
}

TEST_F(JudgeTest, WarnsOfVehiclesThatReceivedNoReport) {
  Judge& judge = For(CommsExpectation{});
  Meet(&judge, 100, 0);
  Meet(&judge, 200, 1);
  judge.tally().fates(Kind::kReport).Add("alpha", "bravo", "delivered");
  judge.tally().fates(Kind::kReport).Add("bravo", "alpha", "out_of_range");
  EXPECT_EQ(judge.Warnings(), Warnings{"received no report of another vehicle: alpha"});
  mission_.vehicles[1].reporter = Provider::kNone;
  EXPECT_EQ(judge.Warnings(), Warnings{}) << "there is none that it could receive";
  mission_.vehicles[1].reporter = Provider::kShoal;
  mission_.broker = Provider::kNone;
  EXPECT_EQ(judge.Warnings(), Warnings{});
}

TEST_F(JudgeTest, WarnsOfAnArrivalThatWasMetFromTheStart) {
  const auto warnings_of = [this](const std::string& vehicle, double first_m, bool stays = false) {
    ArrivalExpectation arrival;
    arrival.vehicle = vehicle;
    arrival.stays = stays;
    Judge& judge = For(arrival);
    for (const auto& [from, to] : {std::pair("alpha", "bravo"), std::pair("bravo", "alpha")}) {
      judge.tally().fates(Kind::kReport).Add(from, to, "delivered");
    }
    Meet(&judge, first_m, 0);
    Meet(&judge, 500, 1);
    Meet(&judge, 100, 2);
    EXPECT_TRUE(judge.Passed());
    return judge.Warnings();
  };
  EXPECT_EQ(
      warnings_of("all", 81),
      Warnings{"an arrival was met before the vehicle had left, by alpha, Bravo: stays = true, "
               "or another point, tests more [berta.toml:88]"});
  EXPECT_EQ(warnings_of("Bravo", 79), Warnings{});
  EXPECT_EQ(warnings_of("Bravo", 100, true), Warnings{});
}

/// Two vessels that meet head-on, `aside_m` beside each other, for 100 s; the second alters course
/// by 30 degrees to starboard at 25 s, on the spot, where it `gives_way`.
void MeetHeadOn(Judge* judge, double aside_m, bool gives_way = false) {
  double x_m = aside_m;
  double y_m = 240;
  for (int step = 0; step <= 1000; ++step) {
    const double heading_deg = gives_way && step >= 250 ? 210 : 180;
    judge->TakeNav(0, {0, 0.3 * step, 0});
    judge->TakeMotion(0, 0, 3);
    judge->TakeNav(1, {x_m, y_m, 0});
    judge->TakeMotion(1, heading_deg, 3);
    judge->EndStep(At(0.1 * step));
    x_m -= gives_way && step >= 250 ? 0.15 : 0;
    y_m -= gives_way && step >= 250 ? 0.2598 : 0.3;
  }
}

TEST_F(JudgeTest, MeasuresTheClosestApproachOfEncounters) {
  ClosestApproachExpectation approach;
  approach.at_least_m = 12;
  MeetHeadOn(&For(approach), 12);
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "encounters of every vehicle with every vehicle not closer than 12 m");
  EXPECT_EQ(Only().numbers, "closest of 1 encounter: alpha-Bravo 12.0 m at 40.0 s");
  approach.vehicle = "Bravo";
  approach.to = "alpha";
  MeetHeadOn(&For(approach), 11.5);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers,
            "closest of 1 encounter: alpha-Bravo 11.5 m at 40.0 s, 0.5 m too close");
}

TEST_F(JudgeTest, DoesNotPassAnEncounterThatNeverWas) {
  ClosestApproachExpectation approach;
  approach.at_least_m = 12;
  MeetHeadOn(&For(approach), 50);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "no encounter was seen");
  EncounterScoreExpectation score;
  MeetHeadOn(&For(score), 50);
  EXPECT_FALSE(Only().passed);
}

TEST_F(JudgeTest, BeginsEncountersWhereTheExpectationSets) {
  ClosestApproachExpectation approach;
  approach.at_least_m = 12;
  approach.encounter.risk_m = 60;
  MeetHeadOn(&For(approach), 50);
  EXPECT_TRUE(Only().passed);
  ASSERT_NE(judge_->encounter_watch(), nullptr);
  EXPECT_EQ(judge_->encounter_watch()->options(), approach.encounter);
}

TEST_F(JudgeTest, ScoresAVehiclesPartInEncounters) {
  EncounterScoreExpectation score;
  score.vehicle = "Bravo";
  score.at_least = 60;
  MeetHeadOn(&For(score), 0, true);
  EXPECT_TRUE(Only().passed) << Only().numbers;
  EXPECT_TRUE(Only().numbers.starts_with("lowest of 1: Bravo as head-on toward alpha "))
      << Only().numbers;
  score.vehicle = "alpha";  // It did nothing.
  MeetHeadOn(&For(score), 0, true);
  EXPECT_FALSE(Only().passed) << Only().numbers;
  EXPECT_TRUE(Only().numbers.ends_with(" too low")) << Only().numbers;
}

TEST_F(JudgeTest, FailsAScoreOfAnotherRole) {
  EncounterScoreExpectation score;
  score.vehicle = "alpha";
  score.role = "give-way";
  MeetHeadOn(&For(score), 12);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "alpha was head-on toward Bravo at 15.1 s, not give-way");
}

TEST_F(JudgeTest, IgnoresMotionThatIsNone) {
  Judge& judge = For(ClosestApproachExpectation());
  EXPECT_FALSE(judge.TakeMotion(0, std::numeric_limits<double>::quiet_NaN(), 3));
  EXPECT_FALSE(judge.TakeMotion(0, 0, std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(judge.TakeMotion(0, 0, -1));
}

}  // namespace shoal::judge_test
