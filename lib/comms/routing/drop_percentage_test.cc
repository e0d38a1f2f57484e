// drop_percentage: how many are lost, and what decides which.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lib/comms/routing/fleet_testing.h"

namespace shoal::drop_percentage_test {

TestFleet MakeFleet(double drop_percentage, uint64_t seed = 1,
                    const std::vector<std::string>& vehicles = {"alpha", "bravo", "charlie"}) {
  RoutingRules rules;
  rules.critical_range_m = 0;
  rules.stale_time_s = -1;
  rules.min_msg_interval_s = -1;
  rules.drop_percentage = drop_percentage;
  return TestFleet(rules, seed, vehicles);
}

/// Which of `count` reports from one vehicle to another are lost.
std::vector<bool> Losses(TestFleet* fleet, int count, const std::string& from = "alpha",
                         const std::string& to = "bravo") {
  std::vector<bool> lost;
  fleet->router.Admit({.name = to}, 0);
  for (int i = 0; i < count; ++i) {
    lost.push_back(fleet->Report(from, {0, 0, 0}).at(to).cause == Cause::kDropped);
  }
  return lost;
}

int64_t NumLost(const std::vector<bool>& lost) {
  return std::count(lost.begin(), lost.end(), true);
}

// Binomial(5,000, p): 4.9 standard deviations, exceeded by chance once in a million.
TEST(DropPercentage, LosesThatManyOfAHundred) {
  constexpr int kReports = 5000;
  for (const double pct : {0.5, 10.0, 50.0, 99.5}) {
    TestFleet fleet = MakeFleet(pct);
    const double p = pct / 100;
    const auto lost = static_cast<double>(NumLost(Losses(&fleet, kReports)));
    EXPECT_NEAR(lost, kReports * p, 4.9 * std::sqrt(kReports * p * (1 - p))) << pct;
  }
}

TEST(DropPercentage, OfZeroLosesNothingAndOfAHundredAll) {
  TestFleet none = MakeFleet(0);
  EXPECT_EQ(NumLost(Losses(&none, 1000)), 0);
  TestFleet all = MakeFleet(100);
  EXPECT_EQ(NumLost(Losses(&all, 1000)), 1000);
}

TEST(DropPercentage, ReturnsTheProbability) {
  TestFleet fleet = MakeFleet(100);
  fleet.Report("bravo", {0, 0, 0});
  EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}).at("bravo").loss_pct, 100);
}

// Which 500 of 1,000 are lost agrees by chance with another choice in 500 +- 16 places.
double Agreement(const std::vector<bool>& a, const std::vector<bool>& b) {
  int same = 0;
  for (size_t i = 0; i < a.size(); ++i) same += a[i] == b[i] ? 1 : 0;
  return static_cast<double>(same) / static_cast<double>(a.size());
}

TEST(DropPercentage, IsTheSameForTheSameSeedAndAnotherForAnother) {
  TestFleet fleet = MakeFleet(50);
  TestFleet same = MakeFleet(50);
  TestFleet other = MakeFleet(50, 2);
  const std::vector<bool> lost = Losses(&fleet, 1000);
  EXPECT_EQ(lost, Losses(&same, 1000));
  EXPECT_NEAR(Agreement(lost, Losses(&other, 1000)), 0.5, 0.08);
}

TEST(DropPercentage, DoesNotDependOnOtherVehicles) {
  TestFleet fleet = MakeFleet(50);
  TestFleet crowded = MakeFleet(50, 1, {"zulu", "charlie", "aaron", "bravo", "alpha"});
  for (const char* other : {"aaron", "zulu", "unregistered"}) {
    crowded.Report(other, {0, 0, 0});
    crowded.Message(other, "all");
  }
  EXPECT_EQ(Losses(&fleet, 1000), Losses(&crowded, 1000));
}

TEST(DropPercentage, DrawsForEachLinkAndDirectionOnItsOwn) {
  TestFleet fleet = MakeFleet(50);
  const std::vector<bool> lost = Losses(&fleet, 1000);
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"alpha", "charlie"}, {"bravo", "alpha"}, {"charlie", "bravo"}}) {
    TestFleet other = MakeFleet(50);
    EXPECT_NEAR(Agreement(lost, Losses(&other, 1000, from, to)), 0.5, 0.08) << from << to;
  }
}

TEST(DropPercentage, DrawsForEachKindOnItsOwn) {
  TestFleet fleet = MakeFleet(50);
  const std::vector<bool> reports = Losses(&fleet, 1000);
  std::vector<bool> messages;
  std::vector<bool> acks;
  for (int i = 0; i < 1000; ++i) {
    messages.push_back(fleet.Message("alpha", "bravo").at("bravo").cause == Cause::kDropped);
    acks.push_back(fleet.Ack("alpha", "bravo").cause == Cause::kDropped);
  }
  EXPECT_NEAR(Agreement(reports, messages), 0.5, 0.08);
  EXPECT_NEAR(Agreement(reports, acks), 0.5, 0.08);
  EXPECT_NEAR(Agreement(messages, acks), 0.5, 0.08);
}

TEST(DropPercentage, DrawsForEachNumberOnItsOwn) {
  TestFleet fleet = MakeFleet(50);
  std::vector<bool> lost = Losses(&fleet, 1001);
  const std::vector<bool> next(lost.begin() + 1, lost.end());
  lost.pop_back();
  EXPECT_NEAR(Agreement(lost, next), 0.5, 0.08);
}

// One draw decides for every percentage, so that a higher one loses what a lower one lost, too.
TEST(DropPercentage, RaisedNeverSavesWhatWasLost) {
  TestFleet low = MakeFleet(20);
  TestFleet high = MakeFleet(60);
  const std::vector<bool> lost_at_20 = Losses(&low, 1000);
  const std::vector<bool> lost_at_60 = Losses(&high, 1000);
  for (size_t i = 0; i < lost_at_20.size(); ++i) EXPECT_LE(lost_at_20[i], lost_at_60[i]) << i;
}

}  // namespace shoal::drop_percentage_test
