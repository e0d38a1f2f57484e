// A random mission through the router and through the oracle: every fate must come out the same.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/comms/routing/oracle_testing.h"
#include "lib/comms/routing/router.h"
#include "lib/comms/routing/traffic_testing.h"

namespace shoal::router_oracle_test {

using oracle::Fate;
using oracle::Oracle;

/// Returns the router's decisions in the oracle's words.
std::vector<Fate> InWords(const Router& router, const std::vector<Decision>& decisions,
                          const std::vector<std::string>& unknown_names) {
  std::vector<Fate> fates;
  for (const Decision& decision : decisions) {
    Fate fate = {.source = "", .destination = "", .numbers = decision};
    if (decision.source >= 0) fate.source = router.contact(decision.source).key;
    if (decision.destination >= 0) fate.destination = router.contact(decision.destination).key;
    if (decision.unknown_name >= 0) {
      fate.destination = unknown_names[static_cast<size_t>(decision.unknown_name)];
    }
    fate.numbers.source = fate.numbers.destination = fate.numbers.unknown_name = -1;
    fates.push_back(fate);
  }
  return fates;
}

constexpr uint64_t kTrafficSeed = 20261121;

/// Both, side by side.
class Comparison {
 public:
  /// One step of random events. Fails where the two differ.
  void Step(bool change_rules) {
    oracle_.now += traffic_.Pause_us();
    expected_.clear();
    decisions_.clear();
    unknown_names_.clear();
    Control(change_rules);
    Reports();
    if (!testing::Test::HasFatalFailure() && traffic_.dice.OneIn(2)) Message();
    if (traffic_.dice.OneIn(3)) Ack();
    ASSERT_EQ(InWords(router_, decisions_, unknown_names_), expected_);
    for (const Decision& decision : decisions_) ++seen_[static_cast<size_t>(decision.cause)];
    oracle_.Forget();
    router_.ForgetSilent(oracle_.now);
  }

  const CauseCounts& seen() const { return seen_; }

 private:
  void Expect(const std::vector<Fate>& fates) {
    expected_.insert(expected_.end(), fates.begin(), fates.end());
  }

  void Control(bool change_rules) {
    if (change_rules) {
      oracle_.rules = traffic_.Rules();
      oracle_.rules.each_fate_up_to = 1'000'000;
      router_.SetRules(oracle_.rules);
    }
    if (traffic_.dice.OneIn(20)) {
      const std::string name = traffic_.Name();
      const LinkFactors factors = traffic_.Factors();
      oracle_.SetFactors(name, factors);
      router_.SetFactors(name, factors);
    }
    if (traffic_.dice.OneIn(30)) {
      const std::string name = traffic_.Name();
      oracle_.RequestFullReports(name);
      router_.RequestFullReports(name);
    }
  }

  void Reports() {
    std::vector<oracle::OracleReport> expected;
    std::vector<Admission> admissions;
    for (int64_t i = traffic_.dice.Below(4); i > 0; --i) {
      const RandomReport report = traffic_.Report();
      expected.push_back(oracle_.Admit(report));
      admissions.push_back(router_.Admit(
          {.name = report.name, .group = report.group, .position_m = report.position_m},
          oracle_.now));
    }
    for (size_t i = 0; i < admissions.size(); ++i) {
      const Fate& fate = expected[i].fate;
      ASSERT_EQ(admissions[i].number, fate.numbers.number);
      ASSERT_EQ(admissions[i].refused.value_or(Cause::kDelivered), fate.numbers.cause);
      ASSERT_EQ(admissions[i].source == kNoContact, fate.source.empty());
      if (admissions[i].refused) {
        ++seen_[static_cast<size_t>(*admissions[i].refused)];
        continue;
      }
      Expect(oracle_.Route(expected[i]));
      router_.Route(admissions[i], oracle_.now, &decisions_);
    }
  }

  void Message() {
    const RandomMessage message = traffic_.Message();
    Expect(oracle_.Message(message));
    router_.RouteMessage({.source = message.source,
                          .dest_node = message.dest_node,
                          .dest_group = message.dest_group,
                          .length_bytes = message.length_bytes,
                          .is_sound = message.is_sound},
                         oracle_.now, &decisions_, &unknown_names_);
  }

  void Ack() {
    RandomMessage ack;
    ack.source = traffic_.Name();
    ack.dest_node = traffic_.Name();
    ack.is_sound = !traffic_.dice.OneIn(20);
    Expect(oracle_.Ack(ack));
    router_.RouteAck({.source = ack.source, .destination = ack.dest_node, .is_sound = ack.is_sound},
                     oracle_.now, &decisions_, &unknown_names_);
  }

  std::vector<std::string> mission_ = {"Bravo", "alpha", "charlie", "delta"};
  RandomTraffic traffic_{kTrafficSeed, {"alpha", "bravo", "charlie", "delta", "nemo", "dory_1"}};
  Oracle oracle_{mission_};
  Router router_{{}, oracle::kSeed, mission_};
  std::vector<Fate> expected_;
  std::vector<Decision> decisions_;
  std::vector<std::string> unknown_names_;
  CauseCounts seen_ = {};
};

TEST(Router, AgreesWithAnOracleOverAHundredThousandRandomSteps) {
  Comparison comparison;
  for (int step = 0; step < 100'000; ++step) {
    comparison.Step(step % 50 == 0);
    ASSERT_FALSE(HasFatalFailure()) << "seed " << kTrafficSeed << ", step " << step;
  }
  for (const CauseRow& row : kCauseTable) {
    if (row.of_rules.empty() || row.cause == Cause::kTooManyVehicles) continue;
    EXPECT_GT(comparison.seen()[static_cast<size_t>(row.cause)], 100)
        << row.key << " was hardly tried";
  }
}

}  // namespace shoal::router_oracle_test
