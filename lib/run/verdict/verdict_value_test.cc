// The numbers of expectations' verdicts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "lib/run/verdict/judge.h"

namespace shoal::verdict_value_test {

int64_t At(double seconds) { return static_cast<int64_t>(seconds * 1e6); }

class VerdictValue : public testing::Test {
 protected:
  Judge& For(const decltype(Expectation::what)& what) {
    mission_.duration_s = 900;
    mission_.vehicles.resize(3);
    mission_.vehicles[0].name = "alpha";
    mission_.vehicles[1].name = "bravo";
    mission_.vehicles[2].name = "charlie";
    mission_.expectations = {{.where = "m.toml:1", .what = what}};
    return judge_.emplace(mission_);
  }
  /// All three at these distances East of the return points, which are at (0, 0).
  void Place(double time_s, double alpha_m, double bravo_m, double charlie_m) {
    judge_->TakeNav(0, {alpha_m, 0, 0});
    judge_->TakeNav(1, {bravo_m, 0, 0});
    judge_->TakeNav(2, {charlie_m, 0, 0});
    judge_->EndStep(At(time_s));
  }
  ExpectationVerdict Only() const { return judge_->Verdicts().at(0); }

  Mission mission_;
  std::optional<Judge> judge_;
};

TEST_F(VerdictValue, OfASeparationIsTheClosestRange) {
  For(SeparationExpectation{.min_m = 5});
  EXPECT_EQ(Only().value, std::nullopt);
  Place(1, 0, 30, 100);
  Place(2, 0, 40, 52);
  EXPECT_EQ(Only().value, 12);
  EXPECT_EQ(Only().unit, "m");
}

TEST_F(VerdictValue, OfAnArrivalIsTheTimeOfTheLast) {
  For(ArrivalExpectation{.vehicle = "all", .point_m = {}, .within_m = 20, .by_s = 600});
  Place(10, 100, 15, 100);
  Place(20, 10, 100, 100);
  Place(700, 10, 100, 20);
  EXPECT_FALSE(Only().passed) << "charlie is late";
  EXPECT_EQ(Only().value, 700);
  EXPECT_EQ(Only().unit, "s");
}

TEST_F(VerdictValue, OfAnArrivalIsNoneWhereOneNeverArrives) {
  For(ArrivalExpectation{.vehicle = "all", .point_m = {}, .within_m = 20, .by_s = 600});
  Place(10, 10, 21, 30);
  Place(700, 10, 21, 20);
  EXPECT_EQ(Only().value, std::nullopt);
  EXPECT_NE(Only().numbers.find("closest: 21.0 m"), std::string::npos) << Only().numbers;
}

TEST_F(VerdictValue, OfDistancesIsThatOfTheVehicleThatDecides) {
  For(DistanceExpectation{.vehicle = "all", .to = "alpha", .min_m = 10, .max_m = 100});
  Place(1, 0, 50, 12);
  EXPECT_EQ(Only().value, 12) << "2 m within the limit; bravo 40 m";
  Place(2, 0, 130, 8);
  EXPECT_EQ(Only().value, 130) << "30 m beyond; charlie 2 m";
  EXPECT_EQ(Only().unit, "m");
}

TEST_F(VerdictValue, OfLapsIsTheFewest) {
  Judge& judge =
      For(LapsExpectation{.vehicle = "all", .task = "survey", .at_least = 3, .by_s = 50});
  judge.TakeHelm(0, {.state = "DRIVE", .task = "survey", .laps_done = 2}, At(10));
  judge.TakeHelm(1, {.state = "DRIVE", .task = "survey", .laps_done = 5}, At(400));
  judge.TakeHelm(2, {.state = "DRIVE", .task = "survey", .laps_done = 3}, At(40));
  EXPECT_EQ(Only().value, 2);
  EXPECT_EQ(Only().unit, "laps");
}

TEST_F(VerdictValue, OfAHelmIsWhetherAllAreThere) {
  Judge& judge = For(HelmExpectation{.vehicle = "all", .state = "PARK", .task = {}});
  EXPECT_EQ(Only().value, 0);
  for (size_t i = 0; i < 3; ++i) judge.TakeHelm(i, {.state = "PARK", .task = {}}, At(1));
  EXPECT_EQ(Only().value, 1);
  judge.TakeHelm(1, {.state = "DRIVE", .task = {}}, At(2));
  EXPECT_EQ(Only().value, 0);
}

TEST_F(VerdictValue, OfTransmissionsIsACountOrAShareAsItIsExpected) {
  Judge& judge = For(CommsExpectation{.at_least = 1});
  for (int i = 0; i < 3; ++i) judge.tally().fates(Kind::kReport).Add("alpha", "bravo", "delivered");
  judge.tally().fates(Kind::kReport).Add("bravo", "alpha", "out_of_range");
  EXPECT_EQ(Only().value, 3);
  EXPECT_EQ(Only().unit, "");
  Judge& by_share = For(CommsExpectation{.at_least_pct = 50});
  EXPECT_EQ(Only().value, std::nullopt) << "nothing was offered";
  for (int i = 0; i < 3; ++i)
    by_share.tally().fates(Kind::kReport).Add("alpha", "bravo", "delivered");
  by_share.tally().fates(Kind::kReport).Add("bravo", "alpha", "out_of_range");
  EXPECT_EQ(Only().value, 75);
  EXPECT_EQ(Only().unit, "%");
}

TEST_F(VerdictValue, OfSwarmMessagesIsTheirShare) {
  Judge& judge = For(SwarmExpectation{.at_least_pct = 10});
  judge.TakeSwarm(0, "bravo", {.clean = 3, .recovered = 1, .rejected = 4});
  EXPECT_EQ(Only().value, 37.5);
}

TEST_F(VerdictValue, OfATrackIsTheLargestErrorOfTheWorst) {
  Judge& judge = For(TrackExpectation{.vehicle = "all", .max_m = 4});
  for (size_t i = 0; i < 3; ++i) {
    judge.TakeHelm(i,
                   {.state = "DRIVE",
                    .task = "go",
                    .cross_track_error_m = i == 1 ? -3.5 : static_cast<double>(i)},
                   At(1));
  }
  Place(1, 0, 50, 100);
  EXPECT_EQ(Only().value, 3.5);
}

TEST_F(VerdictValue, OfAnAltitudeIsTheLowest) {
  Judge& judge = For(AltitudeExpectation{.vehicle = "all", .min_m = 5});
  judge.TakeNav(0, {0, 0, 0}, 12);
  judge.TakeNav(1, {0, 0, 0}, 6.5);
  judge.TakeNav(2, {0, 0, 0}, 9);
  judge.EndStep(At(1));
  EXPECT_EQ(Only().value, 6.5);
}

TEST_F(VerdictValue, OfANavigationErrorIsTheLargest) {
  Judge& judge = For(NavigationErrorExpectation{.vehicle = "alpha", .max_m = 5});
  judge.TakeEstimate(0, {3, 4});
  Place(1, 0, 50, 100);
  judge.TakeEstimate(0, {1, 0});
  Place(2, 0, 50, 100);
  EXPECT_EQ(Only().value, 5);
}

TEST_F(VerdictValue, OfCoverageIsTheShare) {
  Judge& judge = For(CoverageExpectation{.polygon_m = {{0, 0}, {400, 0}, {400, 100}, {0, 100}},
                                         .sensor_width_m = 20,
                                         .at_least_pct = 25,
                                         .vehicles = {"alpha"}});
  for (int i = 0; i <= 250; ++i) {
    judge.TakeNav(0, {2.0 * i - 50, 50, 0});
    judge.EndStep(At(i));
  }
  ASSERT_TRUE(Only().value.has_value());
  EXPECT_NEAR(*Only().value, 20, 0.1);
  EXPECT_EQ(Only().unit, "%");
}

TEST_F(VerdictValue, OfEncountersIsTheClosestAndTheLowestScore) {
  const auto pass = [](Judge* judge) {
    for (int i = 0; i <= 200; ++i) {
      judge->TakeNav(0, {2.0 * i - 200, 0, 0});
      judge->TakeMotion(0, 90, 2);
      judge->TakeNav(1, {200 - 2.0 * i, 20, 0});
      judge->TakeMotion(1, 270, 2);
      judge->EndStep(At(i));
    }
  };
  pass(&For(ClosestApproachExpectation{.at_least_m = 10}));
  ASSERT_TRUE(Only().value.has_value());
  EXPECT_NEAR(*Only().value, 20, 1e-6);
  EXPECT_EQ(Only().unit, "m");
  pass(&For(EncounterScoreExpectation{.at_least = 0, .role = {}}));
  ASSERT_TRUE(Only().value.has_value());
  EXPECT_GT(*Only().value, 0);
  EXPECT_NE(Only().numbers.find(fmt::format(" {:.1f}, closest", *Only().value)), std::string::npos)
      << Only().numbers;
}

}  // namespace shoal::verdict_value_test
