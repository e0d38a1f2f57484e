// each_fate_up_to: looking only at the vehicles that may be near must change no fate.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "lib/comms/routing/fleet_testing.h"
#include "lib/comms/routing/traffic_testing.h"

namespace shoal::far_together_test {

RoutingRules Together(int64_t each_fate_up_to) {
  RoutingRules rules;
  rules.each_fate_up_to = each_fate_up_to;
  return rules;
}

TEST(FarTogether, CountsTheFarInOneFateWithTheReachThatTheyAreOutOf) {
  TestFleet fleet(Together(0));
  fleet.Report("bravo", {99, 0, 0});
  fleet.Report("charlie", {5000, 0, 0});
  fleet.Report("delta", {0, 5000, 0});
  const Fates fates = fleet.Report("alpha", {0, 0, 0});
  ASSERT_EQ(fates.size(), 2U);
  EXPECT_EQ(fates.at("bravo").cause, Cause::kDelivered);
  EXPECT_EQ(fates.at("*").cause, Cause::kOutOfRange);
  EXPECT_EQ(fates.at("*").count, 2);
  EXPECT_EQ(fates.at("*").limit_m, 100);
  EXPECT_EQ(fates.at("*").range_m, -1);
  EXPECT_EQ(CountOf(fleet.At("alpha").sent[0], Cause::kOutOfRange), 2);
}

TEST(FarTogether, DistinguishesTheStaleFromTheFar) {
  TestFleet fleet(Together(0));
  fleet.Report("bravo", {5000, 0, 0});
  fleet.utime = 5 * kSecond_us;
  fleet.Report("charlie", {5000, 0, 0});
  const Fates fates = fleet.Report("alpha", {0, 0, 0});
  ASSERT_EQ(fates.size(), 2U);
  EXPECT_EQ(fates.at("*").cause, Cause::kStaleReceiver);
  EXPECT_EQ(fates.at("*").age_limit_s, 5);
  EXPECT_EQ(fates.at("*+").cause, Cause::kOutOfRange);
}

TEST(FarTogether, BeginsWithOneVehicleMoreThanTheLimit) {
  for (const int64_t limit : {2, 3}) {
    TestFleet fleet(Together(limit));
    fleet.Report("bravo", {5000, 0, 0});
    fleet.Report("charlie", {5000, 0, 0});
    EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}).contains("*"), limit < 3);
  }
}

TEST(FarTogether, NeverHappensWhereTheRangeHasNoLimit) {
  RoutingRules rules = Together(0);
  rules.comms_range_m = -1;
  TestFleet fleet(rules);
  fleet.Report("bravo", {5e6, 0, 0});
  EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}).at("bravo").cause, Cause::kDelivered);
}

TEST(FarTogether, UsesAnEarangeGivenWhileTheMissionRuns) {
  TestFleet fleet(Together(0));
  fleet.Report("bravo", {900, 0, 0});
  EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}).at("*").cause, Cause::kOutOfRange);
  fleet.router.SetFactors("bravo", {.stealth = 1, .earange = 10});
  EXPECT_EQ(fleet.Report("alpha", {0, 0, 0}).at("bravo").cause, Cause::kDelivered);
}

TEST(FarTogether, UsesAStaleTimeChangedBetweenTwoReportsOfAStep) {
  TestFleet fleet(Together(0));
  fleet.Report("bravo", {5000, 0, 0});
  fleet.utime = 2 * kSecond_us;
  const Admission first = fleet.router.Admit({.name = "alpha"}, fleet.utime);
  const Admission second = fleet.router.Admit({.name = "alpha"}, fleet.utime);
  std::vector<Decision> decisions;
  fleet.router.Route(first, fleet.utime, &decisions);
  fleet.ChangeRules([](RoutingRules* rules) { rules->stale_time_s = 1; });
  fleet.router.Route(second, fleet.utime, &decisions);
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_EQ(decisions[0].cause, Cause::kOutOfRange);
  EXPECT_EQ(decisions[1].cause, Cause::kStaleReceiver);
}

TEST(FarTogether, StandsLimitsBeyondAllNumbers) {
  RoutingRules rules = Together(0);
  rules.comms_range_m = std::numeric_limits<double>::max();
  TestFleet fleet(rules);
  fleet.router.SetFactors("bravo", {.stealth = 1, .earange = 10});
  fleet.Report("bravo", {-1e150, 1e150, 0});
  fleet.Report("charlie", {1e8, 0, 0});
  const Fates fates = fleet.Report("alpha", {1, -1, 0});
  EXPECT_EQ(fates.at("bravo").cause, Cause::kDelivered);
  EXPECT_EQ(fates.at("charlie").cause, Cause::kDelivered);
}

/// The same traffic through a router that lists each fate and one that counts the far together.
class Pair {
 public:
  explicit Pair(uint64_t seed)
      : traffic_(seed, {"alpha", "bravo", "c1", "c2", "c3", "c4", "c5", "c6", "c7", "c8"}) {}

  void Step() {
    utime_ += traffic_.Pause_us();
    if (traffic_.dice.OneIn(10)) {
      RoutingRules rules = traffic_.Rules();
      rules.each_fate_up_to = 1'000'000;
      each_.SetRules(rules);
      rules.each_fate_up_to = 0;
      together_.SetRules(rules);
    }
    const std::string name = traffic_.Name();
    if (traffic_.dice.OneIn(10)) {
      const LinkFactors factors = traffic_.Factors();
      RC_ASSERT(each_.SetFactors(name, factors) == together_.SetFactors(name, factors));
    }
    if (traffic_.dice.OneIn(10)) {
      RC_ASSERT(each_.RequestFullReports(name) == together_.RequestFullReports(name));
    }
    std::vector<Admission> admissions;
    for (int64_t i = traffic_.dice.Below(6); i > 0; --i) {
      const RandomReport report = traffic_.Report();
      const ReportFacts facts = {
          .name = report.name, .group = report.group, .position_m = report.position_m};
      admissions.push_back(each_.Admit(facts, utime_));
      RC_ASSERT(together_.Admit(facts, utime_).number == admissions.back().number);
    }
    for (const Admission& admission : admissions) {
      if (admission.refused) continue;
      Compare([&](Router* router, std::vector<Decision>* decisions) {
        router->Route(admission, utime_, decisions);
      });
    }
    const std::string source = traffic_.Name();
    Compare([&](Router* router, std::vector<Decision>* decisions) {
      router->RoutePacket({.source = source}, utime_, decisions);
    });
    each_.ForgetSilent(utime_);
    together_.ForgetSilent(utime_);
    RC_ASSERT(each_.counts(Kind::kReport) == together_.counts(Kind::kReport));
    RC_ASSERT(each_.counts(Kind::kPacket) == together_.counts(Kind::kPacket));
    for (size_t i = 0; i < each_.contacts().size(); ++i) {
      RC_ASSERT(each_.contacts()[i]->sent == together_.contacts()[i]->sent);
    }
  }

 private:
  template <class Route>
  void Compare(const Route& route) {
    std::vector<Decision> each;
    std::vector<Decision> together;
    route(&each_, &each);
    route(&together_, &together);
    size_t next = 0;
    std::map<Cause, int> others;
    for (const Decision& decision : together) {
      if (decision.destination == kOthers) {
        others[decision.cause] -= decision.count;
        continue;
      }
      while (next < each.size() && each[next].destination != decision.destination) {
        ++others[each[next++].cause];
      }
      RC_ASSERT(next < each.size());
      RC_ASSERT(each[next++] == decision);
    }
    for (; next < each.size(); ++next) ++others[each[next].cause];
    for (const auto& [cause, difference] : others) RC_ASSERT(difference == 0);
  }

  RandomTraffic traffic_;
  int64_t utime_ = 0;
  std::vector<std::string> mission_ = {"alpha", "bravo"};
  Router each_{Together(1'000'000), 1, mission_};
  Router together_{Together(0), 1, mission_};
};

RC_GTEST_PROP(FarTogether, ChangesNoFateThatIsListedAndNoSum, (uint64_t seed)) {
  Pair pair(seed);
  const int steps = *rc::gen::inRange(1, 200);
  for (int i = 0; i < steps; ++i) pair.Step();
}

}  // namespace shoal::far_together_test
