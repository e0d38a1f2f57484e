// What holds for every mission.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lib/comms/routing/fleet_testing.h"
#include "lib/comms/routing/traffic_testing.h"

namespace shoal::router_properties_test {

const std::vector<std::string> kMission = {"alpha", "bravo", "charlie"};
const std::vector<std::string> kNames = {"alpha", "bravo", "charlie", "nemo", "dory"};

int64_t SumOfCounts(const std::vector<Decision>& decisions) {
  int64_t sum = 0;
  for (const Decision& decision : decisions) sum += decision.count;
  return sum;
}

/// Counts fates as they are returned, independent of the router's own counters.
struct Ledger {
  KindCounts all = {};
  std::map<std::string, KindCounts> sent;
  std::map<std::string, KindCounts> received;

  void Add(const Router& router, const std::vector<Decision>& decisions) {
    for (const Decision& decision : decisions) {
      const auto kind = static_cast<size_t>(decision.kind);
      const auto cause = static_cast<size_t>(decision.cause);
      all[kind][cause] += decision.count;
      if (decision.source >= 0) {
        sent[router.contact(decision.source).key][kind][cause] += decision.count;
      }
      if (decision.destination >= 0) {
        received[router.contact(decision.destination).key][kind][cause] += decision.count;
      }
    }
  }

  void ExpectAgreement(const Router& router) {
    for (int kind = 0; kind < kNumKinds; ++kind) {
      RC_ASSERT(router.counts(static_cast<Kind>(kind)) == all[static_cast<size_t>(kind)]);
    }
    for (const Contact* contact : router.contacts()) {
      RC_ASSERT(contact->sent == sent[contact->key]);
      RC_ASSERT(contact->received == received[contact->key]);
    }
  }
};

RC_GTEST_PROP(Router, GivesEachTransmissionOneFatePerDestinationAndCountsItOnce, (uint64_t seed)) {
  RandomTraffic traffic(seed, kNames);
  Router router({}, 1, kMission);
  Ledger ledger;
  int64_t utime = 0;
  int64_t report_fates = 0;
  const int steps = *rc::gen::inRange(1, 100);
  for (int i = 0; i < steps; ++i) {
    utime += traffic.Pause_us();
    if (traffic.dice.OneIn(10)) {
      RoutingRules rules = traffic.Rules();
      rules.each_fate_up_to = traffic.dice.Pick<int64_t>({0, 3, 1000});
      router.SetRules(rules);
    }
    const RandomReport report = traffic.Report();
    const Admission admission = router.Admit(
        {.name = report.name, .group = report.group, .position_m = report.position_m}, utime);
    std::vector<Decision> decisions;
    if (admission.refused) {
      decisions.push_back({.source = admission.source, .cause = *admission.refused});
      report_fates += 1;
    } else {
      router.Route(admission, utime, &decisions);
      RC_ASSERT(SumOfCounts(decisions) == router.num_known() - 1);
      report_fates += router.num_known() - 1;
    }
    ledger.Add(router, decisions);
    const RandomMessage message = traffic.Message();
    std::vector<std::string> unknown_names;
    decisions.clear();
    router.RouteMessage({.source = message.source,
                         .dest_node = message.dest_node,
                         .dest_group = message.dest_group,
                         .length_bytes = message.length_bytes,
                         .is_sound = message.is_sound},
                        utime, &decisions, &unknown_names);
    std::set<std::pair<int32_t, int32_t>> destinations;
    for (const Decision& decision : decisions) {
      RC_ASSERT(destinations.insert({decision.destination, decision.unknown_name}).second);
      RC_ASSERT(decision.destination < 0 || decision.destination != decision.source);
    }
    RC_ASSERT(!decisions.empty());
    ledger.Add(router, decisions);
    decisions.clear();
    router.RouteAck({.source = traffic.Name(), .destination = traffic.Name()}, utime, &decisions,
                    &unknown_names);
    RC_ASSERT(decisions.size() == 1U);
    ledger.Add(router, decisions);
    router.ForgetSilent(utime);
    ledger.ExpectAgreement(router);
    RC_ASSERT(Total(router.counts(Kind::kReport)) == report_fates);
    RC_ASSERT(router.num_offered(Kind::kAck) == i + 1);
    RC_ASSERT(Total(router.counts(Kind::kAck)) == i + 1);
  }
}

/// Which vehicle received the report or message of which.
using Deliveries = std::set<std::pair<std::string, std::string>>;

struct Snapshot {
  RoutingRules rules;
  std::vector<RandomReport> reports;
  std::map<std::string, LinkFactors> factors;
};

Snapshot MakeSnapshot(RandomTraffic* traffic) {
  Snapshot snapshot;
  snapshot.rules = traffic->Rules();
  snapshot.rules.stale_time_s = -1;
  snapshot.rules.ignore_group = "";
  snapshot.rules.min_rpt_interval_s = -1;
  snapshot.rules.min_msg_interval_s = -1;
  snapshot.rules.each_fate_up_to = traffic->dice.Pick<int64_t>({0, 1000});
  for (const std::string& name : kNames) {
    RandomReport report = traffic->Report();
    report.name = name;
    if (!report.position_m.allFinite()) report.position_m.setZero();
    snapshot.reports.push_back(report);
    snapshot.factors[name] = traffic->Factors();
  }
  return snapshot;
}

/// All report in this order, then each sends a message to all.
Deliveries Play(const Snapshot& snapshot) {
  Router router(snapshot.rules, 1, kMission);
  for (const auto& [name, factors] : snapshot.factors) router.SetFactors(name, factors);
  std::vector<Admission> admissions;
  for (const RandomReport& report : snapshot.reports) {
    admissions.push_back(router.Admit(
        {.name = report.name, .group = report.group, .position_m = report.position_m}, 0));
  }
  std::vector<Decision> decisions;
  std::vector<std::string> unknown_names;
  for (const Admission& admission : admissions) router.Route(admission, 0, &decisions);
  for (const RandomReport& report : snapshot.reports) {
    router.RouteMessage({.source = report.name, .dest_node = "all"}, 0, &decisions, &unknown_names);
  }
  Deliveries deliveries;
  for (const Decision& decision : decisions) {
    if (decision.cause != Cause::kDelivered) continue;
    deliveries.insert({std::string(KindText(decision.kind)) + router.contact(decision.source).key,
                       router.contact(decision.destination).key});
  }
  return deliveries;
}

void ExpectNothingLost(const Snapshot& before, const Snapshot& after) {
  const Deliveries more = Play(after);
  for (const auto& delivery : Play(before)) RC_ASSERT(more.contains(delivery));
}

RC_GTEST_PROP(MoreReach, NeverLosesADelivery, (uint64_t seed)) {
  RandomTraffic traffic(seed, kNames);
  const Snapshot before = MakeSnapshot(&traffic);
  Snapshot longer = before;
  if (before.rules.comms_range_m >= 0) {
    const double more_m = traffic.dice.Pick({10.0, 500.0});
    longer.rules.comms_range_m = traffic.dice.OneIn(5) ? -1 : before.rules.comms_range_m + more_m;
  }
  ExpectNothingLost(before, longer);
  Snapshot safer = before;
  safer.rules.critical_range_m += 20;
  ExpectNothingLost(before, safer);
  for (const std::string& name : kNames) {
    Snapshot louder = before;
    louder.factors[name].stealth = std::min(1.0, before.factors.at(name).stealth + 0.3);
    ExpectNothingLost(before, louder);
    Snapshot keener = before;
    keener.factors[name].earange = std::min(10.0, before.factors.at(name).earange * 2);
    ExpectNothingLost(before, keener);
  }
}

RC_GTEST_PROP(OrderOfArrival, WithinAStepOfDifferentVehiclesChangesNoDelivery, (uint64_t seed)) {
  RandomTraffic traffic(seed, kNames);
  const Snapshot snapshot = MakeSnapshot(&traffic);
  Snapshot shuffled = snapshot;
  traffic.dice.Shuffle(&shuffled.reports);
  RC_ASSERT(Play(snapshot) == Play(shuffled));
}

/// Plays events with or without what nemo sent before it was forgotten; returns what came after.
std::vector<Decision> AfterNemoIsForgotten(uint64_t seed, bool nemo_was_there) {
  RandomTraffic traffic(seed, kNames);
  RoutingRules rules = traffic.Rules();
  rules.stale_forget_s = 50;
  rules.drop_percentage = 0;  // Numbers are kept, and with them the draws.
  TestFleet fleet(rules, 1, kMission);
  fleet.router.SetFactors("nemo", traffic.Factors());
  std::vector<Decision> later;
  const auto play = [&](bool nemo_sends, bool is_kept) {
    for (int i = 0; i < 60; ++i) {
      const RandomReport report = traffic.Report();
      const RandomMessage message = traffic.Message();
      const bool asks = traffic.dice.OneIn(5);
      fleet.utime += 250'000;
      for (const auto& fates : {VehicleKey(report.name) == "nemo" && !nemo_sends
                                    ? Fates()
                                    : fleet.Report(report.name, report.position_m, report.group),
                                VehicleKey(message.source) == "nemo" && !nemo_sends
                                    ? Fates()
                                    : fleet.Message({.source = message.source,
                                      .dest_node = message.dest_node,
                                      .dest_group = message.dest_group,
                                      .length_bytes = message.length_bytes,
                                      .is_sound = message.is_sound})}) {
        if (!is_kept) continue;
        for (const auto& [name, decision] : fates) later.push_back(decision);
      }
      if (asks && nemo_sends) fleet.router.RequestFullReports("nemo");
    }
  };
  play(nemo_was_there, false);
  fleet.utime += 100 * kSecond_us;
  fleet.router.ForgetSilent(fleet.utime);
  play(true, true);
  for (Decision& decision : later) decision.number = 0;
  return later;
}

RC_GTEST_PROP(Forgetting, LeavesNoTraceInWhatBecomesOfLaterTraffic, (uint64_t seed)) {
  RC_ASSERT(AfterNemoIsForgotten(seed, true) == AfterNemoIsForgotten(seed, false));
}

}  // namespace shoal::router_properties_test
