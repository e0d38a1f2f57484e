// Node reports: intake, fan-out, intervals, full-report requests.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "lib/base/time/seconds.h"
#include "lib/comms/routing/fleet_testing.h"

namespace shoal::report_routing_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Reports, GoNowhereWhileNoOtherVehicleIsKnown) {
  TestFleet fleet;
  EXPECT_EQ(fleet.router.num_known(), 0);
  EXPECT_TRUE(fleet.Report("alpha", {0, 0, 0}).empty());
  EXPECT_EQ(fleet.router.num_known(), 1);
  EXPECT_EQ(fleet.router.num_offered(Kind::kReport), 1);
}

// The manual, sections 1 and 2.3.
TEST(Reports, OfThreeVehiclesGoToTheTwoOthersEach) {
  TestFleet fleet;
  fleet.Report("alpha", {0, 0, 0});
  fleet.Report("bravo", {50, 0, 0});
  fleet.Report("charlie", {0, 50, 0});
  fleet.utime = kSecond_us / 4;
  for (const char* source : {"alpha", "bravo", "charlie"}) {
    const Fates fates = fleet.Report(source, fleet.At(source).position_m);
    ASSERT_EQ(fates.size(), 2U);
    for (const auto& [destination, decision] : fates) {
      EXPECT_NE(destination, source);
      EXPECT_EQ(decision.cause, Cause::kDelivered);
      EXPECT_EQ(decision.source, fleet.At(source).index);
      EXPECT_EQ(decision.number, 1);
    }
  }
  EXPECT_EQ(CountOf(fleet.router.counts(Kind::kReport), Cause::kDelivered), 0 + 1 + 2 + 3 * 2);
}

TEST(Reports, GoToVehiclesInOrderOfTheirNames) {
  TestFleet fleet;
  for (const char* name : {"zulu", "Mike", "alpha", "bravo"}) fleet.Report(name, {0, 0, 0});
  const Admission admission = fleet.router.Admit({.name = "bravo"}, 0);
  std::vector<Decision> decisions;
  fleet.router.Route(admission, 0, &decisions);
  std::vector<std::string> names;
  for (const Decision& decision : decisions) {
    names.push_back(fleet.router.contact(decision.destination).name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"alpha", "Mike", "zulu"}));
}

TEST(Reports, OfOneVehicleInOneStepAreEachHandledWhereTheyWereSent) {
  TestFleet fleet({.comms_range_m = 100, .critical_range_m = 0});
  fleet.Report("bravo", {0, 0, 0});
  const Admission near = fleet.router.Admit({.name = "alpha", .position_m = {99, 0, 0}}, 0);
  const Admission far = fleet.router.Admit({.name = "alpha", .position_m = {101, 0, 0}}, 0);
  std::vector<Decision> decisions;
  fleet.router.Route(near, 0, &decisions);
  fleet.router.Route(far, 0, &decisions);
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_EQ(decisions[0].cause, Cause::kDelivered);
  EXPECT_EQ(decisions[0].range_m, 99);
  EXPECT_EQ(decisions[1].cause, Cause::kOutOfRange);
  EXPECT_EQ(decisions[1].number, decisions[0].number + 1);
}

TEST(Reports, OfOneVehicleInOneStepKeepTheGroupThatEachStates) {
  RoutingRules rules;
  rules.groups = true;
  TestFleet fleet(rules);
  fleet.Report("bravo", {50, 0, 0}, "red");
  const Admission red = fleet.router.Admit({.name = "alpha", .group = "red"}, 0);
  const Admission blue = fleet.router.Admit({.name = "alpha", .group = "blue"}, 0);
  std::vector<Decision> decisions;
  fleet.router.Route(red, 0, &decisions);
  fleet.router.Route(blue, 0, &decisions);
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_EQ(decisions[0].cause, Cause::kDelivered);
  EXPECT_EQ(decisions[1].cause, Cause::kOtherGroup);
}

TEST(Reports, TakeNamesAndGroupsWithoutRegardToCase) {
  TestFleet fleet;
  fleet.ChangeRules([](RoutingRules* rules) { rules->groups = true; });
  fleet.Report("BRAVO", {50, 0, 0}, "Red_Team");
  fleet.Report("Bravo", {60, 0, 0}, "RED_team");
  EXPECT_EQ(fleet.router.num_known(), 1);
  EXPECT_EQ(fleet.At("bravo").name, "bravo") << "as the mission writes it";
  const Fates fates = fleet.Report("alpha", {0, 0, 0}, "red_TEAM");
  EXPECT_EQ(fates.at("bravo").cause, Cause::kDelivered);
  EXPECT_EQ(fates.at("bravo").range_m, 60);
}

TEST(Intake, RefusesImpossibleReportsAndKeepsWhatItKnew) {
  TestFleet fleet;
  fleet.Report("alpha", {1, 0, 0}, "red");
  fleet.utime = kSecond_us;
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::Vector3d position_m(5, 5, 5);
      position_m[axis] = bad;
      const Fates fates = fleet.Report("alpha", position_m, "blue");
      EXPECT_EQ(fates.at("").cause, Cause::kInvalid);
      EXPECT_EQ(fates.at("").source, fleet.At("alpha").index);
    }
  }
  EXPECT_EQ(fleet.At("alpha").position_m.x(), 1);
  EXPECT_EQ(fleet.At("alpha").group_key, "red");
  EXPECT_EQ(fleet.At("alpha").received_utime, 0);
  EXPECT_EQ(CountOf(fleet.At("alpha").sent[0], Cause::kInvalid), 9);
}

TEST(Intake, RefusesIllegalNamesAndAddsNoVehicle) {
  TestFleet fleet;
  const std::vector<std::string> illegal = {"",    "no spaces", "all",  "Local",
                                            "UNC", "a:b",       "\xff", std::string(33, 'x')};
  for (const std::string& name : illegal) {
    EXPECT_EQ(fleet.Report(name, {0, 0, 0}).at("").cause, Cause::kInvalid) << name;
  }
  EXPECT_EQ(fleet.router.Admit({.name = "nemo", .position_m = {kNan, 0, 0}}, 0).source, kNoContact);
  EXPECT_EQ(fleet.router.Refuse("nemo").source, kNoContact);
  EXPECT_EQ(fleet.router.num_known(), 0);
  EXPECT_EQ(fleet.router.contacts().size(), 3U);
  EXPECT_EQ(CountOf(fleet.router.counts(Kind::kReport), Cause::kInvalid), 10);
  EXPECT_EQ(fleet.router.num_offered(Kind::kReport), 10);
}

TEST(IgnoreGroup, DropsReportsOfThatGroupAtIntake) {
  TestFleet fleet;
  fleet.ChangeRules([](RoutingRules* rules) { rules->ignore_group = "Ghosts"; });
  EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}, "gHOSTS").at("").cause, Cause::kIgnoredGroup);
  EXPECT_FALSE(fleet.At("alpha").known);
  EXPECT_EQ(CountOf(fleet.At("alpha").sent[0], Cause::kIgnoredGroup), 1);
  fleet.Report("alpha", {0, 0, 0}, "ghosts2");
  EXPECT_TRUE(fleet.At("alpha").known);
}

TEST(IgnoreGroup, LetsAVehicleThatWasKnownGrowStale) {
  TestFleet fleet;
  fleet.ChangeRules([](RoutingRules* rules) { rules->ignore_group = "ghosts"; });
  fleet.Report("alpha", {0, 0, 0});
  fleet.Report("bravo", {1, 0, 0});
  fleet.utime = 5 * kSecond_us;
  fleet.Report("alpha", {0, 0, 0}, "ghosts");
  EXPECT_EQ(fleet.Report("bravo", {1, 0, 0}).at("alpha").cause, Cause::kStaleReceiver);
}

TEST(IgnoreGroup, ComesBeforeARequestForTheReport) {
  TestFleet fleet;
  fleet.ChangeRules([](RoutingRules* rules) { rules->ignore_group = "ghosts"; });
  fleet.Report("bravo", {1, 0, 0});
  fleet.router.RequestFullReports("bravo");
  EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}, "ghosts").at("").cause, Cause::kIgnoredGroup);
}

TEST(IgnoreGroup, OfNoNameDoesNotMeanVehiclesWithoutGroup) {
  TestFleet fleet;
  EXPECT_FALSE(fleet.Report("alpha", {0, 0, 0}, "").contains(""));
}

/// The cause of a report from alpha to bravo, sent this long after the first.
Cause CauseAfter(int64_t elapsed_us, double min_rpt_interval_s) {
  TestFleet fleet({.critical_range_m = 0, .stale_time_s = -1});
  RoutingRules rules = fleet.router.rules();
  rules.min_rpt_interval_s = min_rpt_interval_s;
  fleet.router.SetRules(rules);
  fleet.Report("bravo", {0, 0, 0});
  EXPECT_EQ(fleet.Report("alpha", {50, 0, 0}).at("bravo").cause, Cause::kDelivered);
  fleet.utime += elapsed_us;
  const Decision decision = fleet.Report("alpha", {50, 0, 0}).at("bravo");
  if (decision.cause == Cause::kTooSoon) {
    EXPECT_DOUBLE_EQ(decision.wait_s, min_rpt_interval_s - Seconds(elapsed_us));
  }
  return decision.cause;
}

TEST(MinRptInterval, StopsAReportJustTooSoonAndLetsItThroughExactlyThen) {
  EXPECT_EQ(CauseAfter(9'999'999, 10), Cause::kTooSoon);
  EXPECT_EQ(CauseAfter(10'000'000, 10), Cause::kDelivered);
  EXPECT_EQ(CauseAfter(10'000'001, 10), Cause::kDelivered);
}

TEST(MinRptInterval, IsOffWhereNegativeOrZero) {
  EXPECT_EQ(CauseAfter(0, -1), Cause::kDelivered);
  EXPECT_EQ(CauseAfter(0, 0), Cause::kDelivered);
}

TEST(MinRptInterval, HoldsForEachOrderedPairAndCountsFromADelivery) {
  TestFleet fleet({.critical_range_m = 0});
  fleet.ChangeRules([](RoutingRules* rules) {
    rules->min_rpt_interval_s = 10;
    rules->stale_time_s = -1;
  });
  fleet.Report("bravo", {0, 0, 0});
  fleet.Report("charlie", {1000, 0, 0});
  EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}).at("bravo").cause, Cause::kDelivered);
  EXPECT_EQ(fleet.Report("bravo", {0, 0, 0}).at("alpha").cause, Cause::kDelivered)
      << "the other direction has an interval of its own";
  fleet.utime = 4 * kSecond_us;
  fleet.Report("charlie", {0, 0, 0});
  const Fates fates = fleet.Report("alpha", {0, 0, 0});
  EXPECT_EQ(fates.at("bravo").cause, Cause::kTooSoon);
  EXPECT_EQ(fates.at("bravo").wait_s, 6);
  EXPECT_EQ(fates.at("charlie").cause, Cause::kDelivered) << "it was out of range before";
  fleet.utime = 10 * kSecond_us;
  EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}).at("bravo").cause, Cause::kDelivered)
      << "what came too soon did not restart the interval";
}

TEST(MinRptInterval, IsRestartedByADeliveryWithinTheCriticalRange) {
  TestFleet fleet;
  fleet.ChangeRules([](RoutingRules* rules) { rules->min_rpt_interval_s = 10; });
  fleet.Report("bravo", {0, 0, 0});
  EXPECT_EQ(fleet.Report("alpha", {1, 0, 0}).at("bravo").override_rule,
            OverrideRule::kCriticalRange);
  EXPECT_EQ(fleet.Report("alpha", {1, 0, 0}).at("bravo").cause, Cause::kDelivered);
  EXPECT_EQ(fleet.Report("alpha", {50, 0, 0}).at("bravo").cause, Cause::kTooSoon);
}

TEST(FullReportRequest, DeliversTheNextReportOfEachOtherVehicleOnceWhateverTheRules) {
  TestFleet fleet({.comms_range_m = 0});
  fleet.ChangeRules([](RoutingRules* rules) {
    rules->groups = true;
    rules->drop_percentage = 100;
  });
  fleet.Report("alpha", {0, 0, 0}, "red");
  fleet.Report("bravo", {1e6, 0, 0}, "blue");
  fleet.Report("charlie", {-1e6, 0, 0}, "green");
  fleet.utime = 60 * kSecond_us;
  ASSERT_TRUE(fleet.router.RequestFullReports("ALPHA"));
  for (const char* source : {"bravo", "charlie"}) {
    const Eigen::Vector3d where_m = fleet.At(source).position_m;
    const Decision first = fleet.Report(source, where_m, "blue").at("alpha");
    EXPECT_EQ(first.cause, Cause::kDelivered) << "alpha is stale, of another group, out of range";
    EXPECT_EQ(first.override_rule, OverrideRule::kFullReport);
    EXPECT_EQ(fleet.Report(source, where_m, "blue").at("alpha").cause, Cause::kStaleReceiver);
  }
  EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}, "red").at("bravo").cause, Cause::kOutOfRange)
      << "only the one that was named receives";
}

TEST(FullReportRequest, WaitsForVehiclesOfTheMissionThatHaveNotReportedYet) {
  TestFleet fleet({.comms_range_m = 0});
  ASSERT_TRUE(fleet.router.RequestFullReports("alpha"));
  fleet.Report("alpha", {0, 0, 0});
  EXPECT_EQ(fleet.Report("bravo", {99, 0, 0}).at("alpha").override_rule, OverrideRule::kFullReport);
  EXPECT_EQ(fleet.Report("bravo", {99, 0, 0}).at("alpha").cause, Cause::kOutOfRange);
}

TEST(FullReportRequest, AskedTwiceStillDeliversOnce) {
  TestFleet fleet({.comms_range_m = 0});
  fleet.Report("alpha", {0, 0, 0});
  fleet.router.RequestFullReports("alpha");
  fleet.router.RequestFullReports("alpha");
  EXPECT_EQ(fleet.Report("bravo", {99, 0, 0}).at("alpha").cause, Cause::kDelivered);
  EXPECT_EQ(fleet.Report("bravo", {99, 0, 0}).at("alpha").cause, Cause::kOutOfRange);
}

TEST(FullReportRequest, IsRefusedForAVehicleNeitherKnownNorOfTheMission) {
  TestFleet fleet;
  EXPECT_FALSE(fleet.router.RequestFullReports("nemo"));
  EXPECT_FALSE(fleet.router.RequestFullReports("not a name"));
  fleet.Report("nemo", {0, 0, 0});
  EXPECT_TRUE(fleet.router.RequestFullReports("nemo"));
}

}  // namespace shoal::report_routing_test
