// Which vehicles are forgotten, what is kept of them, and the limit of unregistered vehicles.
#include <gtest/gtest.h>

#include <string>

#include "lib/comms/routing/fleet_testing.h"

namespace shoal::forgetting_test {

RoutingRules ForgetAfter(double stale_forget_s) {
  RoutingRules rules;
  rules.stale_forget_s = stale_forget_s;
  return rules;
}

TEST(Forgetting, HappensExactlyAtTheForgetTime) {
  TestFleet fleet(ForgetAfter(100));
  fleet.Report("bravo", {0, 0, 0});
  std::vector<int32_t> forgotten;
  fleet.router.ForgetSilent(100 * kSecond_us - 1, &forgotten);
  EXPECT_TRUE(forgotten.empty());
  fleet.utime = 100 * kSecond_us;
  EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}).at("bravo").cause, Cause::kStaleReceiver);
  fleet.router.ForgetSilent(fleet.utime, &forgotten);
  EXPECT_EQ(forgotten, std::vector<int32_t>{fleet.At("bravo").index});
  EXPECT_EQ(fleet.router.num_known(), 1);
  EXPECT_TRUE(fleet.Report("alpha", {0, 0, 0}).empty());
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kUnknownDestination);
  EXPECT_EQ(fleet.Message("bravo", "alpha").at("alpha").cause, Cause::kUnknownSource);
}

TEST(Forgetting, NeverHappensWhereNegative) {
  TestFleet fleet(ForgetAfter(-1));
  fleet.Report("bravo", {0, 0, 0});
  fleet.router.ForgetSilent(1'000'000 * kSecond_us);
  EXPECT_EQ(fleet.router.num_known(), 1);
}

TEST(Forgetting, HappensAtOnceWhereZero) {
  TestFleet fleet(ForgetAfter(0));
  fleet.Report("bravo", {0, 0, 0});
  fleet.router.ForgetSilent(0);
  EXPECT_EQ(fleet.router.num_known(), 0);
}

TEST(Forgetting, KeepsFactorsNumbersAndCounts) {
  TestFleet fleet(ForgetAfter(10));
  fleet.Report("alpha", {0, 0, 0});
  fleet.router.SetFactors("bravo", {.stealth = 0.5, .earange = 3});
  fleet.Report("bravo", {49, 0, 0});
  fleet.Message("bravo", "alpha");
  fleet.utime = 10 * kSecond_us;
  fleet.router.ForgetSilent(fleet.utime);
  EXPECT_EQ(fleet.At("bravo").factors, (LinkFactors{.stealth = 0.5, .earange = 3}));
  fleet.Report("alpha", {0, 0, 0});
  const Decision decision = fleet.Report("bravo", {51, 0, 0}).at("alpha");
  EXPECT_EQ(decision.cause, Cause::kOutOfRange);
  EXPECT_EQ(decision.limit_m, 50);
  EXPECT_EQ(decision.number, 1);
  EXPECT_EQ(fleet.Message("bravo", "alpha").at("alpha").number, 1);
  EXPECT_EQ(CountOf(fleet.At("bravo").sent[0], Cause::kDelivered), 1);
  EXPECT_EQ(fleet.At("bravo").num_admitted, 2);
  EXPECT_EQ(fleet.router.num_admitted(), 4);
}

TEST(Forgetting, EndsGroupIntervalsAndRequests) {
  RoutingRules rules = ForgetAfter(10);
  rules.min_rpt_interval_s = 1000;
  rules.min_msg_interval_s = 1000;
  rules.critical_range_m = 0;
  TestFleet fleet(rules);
  fleet.Report("alpha", {0, 0, 0}, "red");
  fleet.Report("bravo", {50, 0, 0}, "red");
  fleet.Report("alpha", {0, 0, 0}, "red");
  fleet.Message("bravo", "alpha");
  fleet.router.RequestFullReports("bravo");
  fleet.utime = 9 * kSecond_us;
  fleet.Report("alpha", {0, 0, 0}, "red");  // Uses one request up; the one for charlie is left.
  fleet.router.RequestFullReports("bravo");
  fleet.utime = 10 * kSecond_us;
  fleet.router.ForgetSilent(fleet.utime);
  ASSERT_FALSE(fleet.At("bravo").known);
  EXPECT_EQ(fleet.Message({.source = "alpha", .dest_group = "red"}).at("").cause,
            Cause::kNoDestination);
  EXPECT_EQ(fleet.Report("bravo", {50, 0, 0}).at("alpha").cause, Cause::kDelivered)
      << "bravo's reports to alpha have no interval to wait for";
  const Decision to_bravo = fleet.Report("alpha", {0, 0, 0}).at("bravo");
  EXPECT_EQ(to_bravo.cause, Cause::kDelivered) << "nor have alpha's to bravo";
  EXPECT_EQ(to_bravo.override_rule, OverrideRule::kNone) << "bravo's request is gone";
  EXPECT_EQ(fleet.Message("bravo", "alpha").at("alpha").cause, Cause::kDelivered);
}

TEST(Forgetting, OfASourceLeavesTheRequestForItsReportOpen) {
  RoutingRules rules = ForgetAfter(10);
  rules.comms_range_m = 0;
  TestFleet fleet(rules);
  fleet.Report("bravo", {0, 0, 0});
  fleet.Report("alpha", {0, 0, 0});
  fleet.router.RequestFullReports("alpha");
  fleet.utime = 9 * kSecond_us;
  fleet.Report("alpha", {0, 0, 0});
  fleet.utime = 10 * kSecond_us;
  fleet.router.ForgetSilent(fleet.utime);
  ASSERT_FALSE(fleet.At("bravo").known);
  EXPECT_EQ(fleet.Report("bravo", {99, 0, 0}).at("alpha").override_rule, OverrideRule::kFullReport);
}

TEST(Factors, AreKeptForAVehicleThatHasNotReportedYetOfTheMissionOrNot) {
  TestFleet fleet;
  EXPECT_TRUE(fleet.router.SetFactors("NEMO", {.stealth = 0.25, .earange = 1}));
  EXPECT_TRUE(fleet.router.SetFactors("Bravo", {.stealth = 1, .earange = 2}));
  EXPECT_EQ(fleet.router.num_known(), 0);
  fleet.Report("bravo", {0, 0, 0});
  EXPECT_EQ(fleet.Report("nemo", {40, 0, 0}).at("bravo").limit_m, 50) << "100 x 0.25 x 2";
  EXPECT_EQ(fleet.router.FindFactors("nEMo"), (LinkFactors{.stealth = 0.25, .earange = 1}));
}

TEST(Factors, AreOnesForAnUnusedNameAndAskingMakesNoVehicleKnown) {
  const TestFleet fleet;
  EXPECT_EQ(fleet.router.FindFactors("nemo"), LinkFactors());
  EXPECT_EQ(fleet.router.contacts().size(), 3U);
}

TEST(Factors, AreRefusedForIllegalNames) {
  TestFleet fleet;
  for (const char* name : {"", "all", "a b"}) {
    EXPECT_FALSE(fleet.router.SetFactors(name, {}));
    EXPECT_EQ(fleet.router.FindFactors(name), std::nullopt);
  }
}

/// Admits reports of `count` unregistered vehicles; returns how many were refused.
int ReportUnregistered(TestFleet* fleet, const std::string& prefix, int count) {
  int num_refused = 0;
  for (int i = 0; i < count; ++i) {
    const std::string name = prefix + std::to_string(i);
    if (fleet->router.Admit({.name = name}, fleet->utime).refused) ++num_refused;
  }
  return num_refused;
}

TEST(UnregisteredVehicles, AreRefusedBeyondTheirLimitAndNeverReplaceTheMissionsVehicles) {
  TestFleet fleet(ForgetAfter(10));
  EXPECT_EQ(ReportUnregistered(&fleet, "made_up_", Router::kMaxUnregistered + 7), 7);
  EXPECT_EQ(CountOf(fleet.router.counts(Kind::kReport), Cause::kTooManyVehicles), 7);
  EXPECT_FALSE(fleet.router.Admit({.name = "alpha"}, 0).refused);
  EXPECT_FALSE(fleet.router.SetFactors("one_more", {}));
  EXPECT_EQ(fleet.router.FindFactors("one_more"), std::nullopt);
  EXPECT_EQ(fleet.Message("one_more", "alpha").at("").cause, Cause::kTooManyVehicles);
  EXPECT_EQ(fleet.Message("made_up_7", "alpha").at("alpha").cause, Cause::kDelivered);
}

TEST(UnregisteredVehicles, ThatAreForgottenMakeRoomForNewOnes) {
  TestFleet fleet(ForgetAfter(10));
  ReportUnregistered(&fleet, "made_up_", Router::kMaxUnregistered);
  fleet.utime = 9 * kSecond_us;
  fleet.Report("made_up_7", {0, 0, 0});
  fleet.router.ForgetSilent(10 * kSecond_us);
  EXPECT_EQ(fleet.router.num_known(), 1);
  EXPECT_EQ(ReportUnregistered(&fleet, "newcomer_", Router::kMaxUnregistered), 1);
  EXPECT_EQ(fleet.router.num_known(), Router::kMaxUnregistered);
  EXPECT_TRUE(fleet.At("made_up_7").known);
  for (const Contact* contact : fleet.router.contacts()) {
    EXPECT_EQ(&fleet.router.contact(contact->index), contact);
  }
}

TEST(UnregisteredVehicles, ThatWereGivenFactorsAreReplacedLast) {
  TestFleet fleet;
  fleet.router.SetFactors("a_friend", {.stealth = 0.5});
  for (int i = 0; i < 2 * Router::kMaxUnregistered; ++i) {
    fleet.Message("made_up_" + std::to_string(i), "alpha");
  }
  EXPECT_EQ(fleet.router.contacts().size(), 3U + Router::kMaxUnregistered);
  EXPECT_EQ(fleet.router.FindFactors("a_friend")->stealth, 0.5);
}

TEST(UnregisteredVehicles, InAPlaceThatWasAnothersInheritNothing) {
  RoutingRules rules = ForgetAfter(10);
  rules.comms_range_m = 0;
  TestFleet fleet(rules);
  fleet.Report("alpha", {99, 0, 0});
  ReportUnregistered(&fleet, "made_up_", Router::kMaxUnregistered);
  fleet.router.RequestFullReports("alpha");
  fleet.utime = 9 * kSecond_us;
  fleet.Report("alpha", {99, 0, 0});
  fleet.utime = 10 * kSecond_us;
  fleet.router.ForgetSilent(fleet.utime);
  ReportUnregistered(&fleet, "newcomer_", Router::kMaxUnregistered - 1);
  EXPECT_EQ(fleet.Report("newcomer_0", {0, 0, 0}).at("alpha").cause, Cause::kOutOfRange)
      << "alpha asked for the report of the vehicle that had this place before";
}

}  // namespace shoal::forgetting_test
