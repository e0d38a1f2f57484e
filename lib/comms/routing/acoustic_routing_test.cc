// What goes over the acoustic network: packets, and reports and messages where the rules route them
// there.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "lib/comms/routing/fleet_testing.h"
#include "lib/comms/routing/traffic_testing.h"

namespace shoal::acoustic_routing_test {

Fates SendPacket(TestFleet* fleet, std::string_view source, int64_t length_bytes = 10,
                 bool is_sound = true) {
  std::vector<Decision> decisions;
  fleet->router.RoutePacket({.source = source,
                             .length_bytes = length_bytes,
                             .length_limit_bytes = 64,
                             .is_sound = is_sound},
                            fleet->utime, &decisions);
  return fleet->ByName(decisions, {});
}

RoutingRules OverTheWater(int64_t each_fate_up_to = 200) {
  RoutingRules rules;
  rules.reports_over = Over("acoustic");
  rules.messages_over = Over("acoustic");
  rules.each_fate_up_to = each_fate_up_to;
  return rules;
}

TEST(Packet, IsInTransitToAllVehiclesThatAreNear) {
  TestFleet fleet;
  fleet.Report("alpha", {0, 0, 0});
  fleet.Report("bravo", {99, 0, 0});
  fleet.Report("charlie", {0, 0, 100});
  const Fates fates = SendPacket(&fleet, "alpha");
  ASSERT_EQ(fates.size(), 2U);
  EXPECT_EQ(fates.at("bravo").cause, Cause::kInTransit);
  EXPECT_EQ(fates.at("bravo").range_m, 99);
  EXPECT_EQ(fates.at("bravo").kind, Kind::kPacket);
  EXPECT_EQ(fates.at("charlie").cause, Cause::kOutOfRange);
  EXPECT_EQ(fates.at("charlie").limit_m, 100);
  EXPECT_EQ(SendPacket(&fleet, "alpha").at("bravo").number, 1);
}

TEST(Packet, GoesByWhereVehiclesAreInTruthWhetherFatesAreCountedOrNot) {
  for (const int64_t each_fate_up_to : {200, 0}) {
    TestFleet fleet(OverTheWater(each_fate_up_to));
    fleet.Report("alpha", {0, 0, 0});
    fleet.Report("bravo", {393, 0, 0});
    fleet.Report("charlie", {20, 0, 0});
    fleet.router.PlaceTruth("ALPHA", {10, 0, 0});
    fleet.router.PlaceTruth("bravo", {46, 0, 0});
    fleet.router.PlaceTruth("charlie", {5000, 0, 0});
    fleet.router.PlaceTruth("not_of_the_mission", {0, 0, 0});
    const Fates fates = SendPacket(&fleet, "alpha");
    ASSERT_EQ(fates.size(), 2U);
    EXPECT_EQ(fates.at("bravo").cause, Cause::kInTransit);
    EXPECT_EQ(fates.at("bravo").range_m, 36);
    EXPECT_EQ(fates.at("charlie").cause, Cause::kOutOfRange);
    EXPECT_EQ(fates.at("charlie").range_m, 4990);
  }
}

TEST(Packet, NeedsNoReportsWherePlacesInTruthAreKnown) {
  TestFleet fleet;
  fleet.router.PlaceTruth("alpha", {0, 0, 0});
  EXPECT_EQ(SendPacket(&fleet, "alpha").at("").cause, Cause::kNoDestination);
  EXPECT_EQ(SendPacket(&fleet, "bravo").at("").cause, Cause::kUnknownSource);
  fleet.router.PlaceTruth("bravo", {50, 0, 0});
  EXPECT_EQ(SendPacket(&fleet, "alpha").at("bravo").cause, Cause::kInTransit);
  fleet.Report("charlie", {20, 0, 0});
  const Fates reported = fleet.Report("charlie", {20, 0, 0});
  EXPECT_TRUE(reported.empty()) << "reports need reports of their receivers";
}

TEST(Packet, OfAModemHasNoRangeRule) {
  for (const int64_t each_fate_up_to : {200, 0}) {
    TestFleet fleet(OverTheWater(each_fate_up_to));
    fleet.ChangeRules([](RoutingRules* rules) { rules->comms_range_m = 100; });
    fleet.Report("alpha", {0, 0, 0});
    fleet.Report("bravo", {5000, 0, 0});
    std::vector<Decision> decisions;
    fleet.router.RoutePacket(
        {.source = "alpha", .length_bytes = 10, .length_limit_bytes = 64, .has_range_rule = false},
        fleet.utime, &decisions);
    ASSERT_EQ(decisions.size(), 1U);
    EXPECT_EQ(decisions[0].cause, Cause::kInTransit);
    EXPECT_EQ(decisions[0].range_m, 5000);
    EXPECT_EQ(decisions[0].limit_m, -1);
  }
}

TEST(Packet, ArrivesAsFarAsStealthAndEarangeAllow) {
  TestFleet fleet;
  fleet.Report("alpha", {0, 0, 0});
  fleet.Report("bravo", {60, 0, 0});
  fleet.router.SetFactors("alpha", {.stealth = 0.5, .earange = 1});
  EXPECT_EQ(SendPacket(&fleet, "alpha").at("bravo").cause, Cause::kOutOfRange);
  EXPECT_EQ(SendPacket(&fleet, "bravo").at("alpha").cause, Cause::kInTransit);
  fleet.router.SetFactors("bravo", {.stealth = 1, .earange = 1.5});
  EXPECT_EQ(SendPacket(&fleet, "alpha").at("bravo").cause, Cause::kInTransit);
}

TEST(Packet, AsksNoOtherRule) {
  RoutingRules rules;
  rules.groups = true;
  rules.msg_groups = true;
  rules.drop_percentage = 100;
  rules.min_msg_interval_s = 1000;
  rules.stale_forget_s = 1000;
  TestFleet fleet(rules);
  fleet.Report("alpha", {0, 0, 0}, "red");
  fleet.Report("bravo", {50, 0, 0}, "blue");
  fleet.utime = 500 * kSecond_us;
  EXPECT_EQ(SendPacket(&fleet, "alpha").at("bravo").cause, Cause::kInTransit);
  EXPECT_EQ(SendPacket(&fleet, "alpha").at("bravo").cause, Cause::kInTransit);
}

TEST(Packet, IsRefusedWhereItCannotGoAnywhere) {
  TestFleet fleet;
  EXPECT_EQ(SendPacket(&fleet, "alpha").at("").cause, Cause::kUnknownSource);
  EXPECT_EQ(SendPacket(&fleet, "nemo").at("").cause, Cause::kUnknownSource);
  fleet.Report("alpha", {0, 0, 0});
  EXPECT_EQ(SendPacket(&fleet, "alpha").at("").cause, Cause::kNoDestination);
  EXPECT_EQ(SendPacket(&fleet, "alpha", 10, false).at("").cause, Cause::kInvalid);
  EXPECT_EQ(SendPacket(&fleet, "no name").at("").cause, Cause::kInvalid);
  EXPECT_EQ(SendPacket(&fleet, "alpha", 64).at("").cause, Cause::kNoDestination);
  const Decision too_long = SendPacket(&fleet, "alpha", 65).at("");
  EXPECT_EQ(too_long.cause, Cause::kTooLong);
  EXPECT_EQ(too_long.length_bytes, 65);
  EXPECT_EQ(too_long.length_limit_bytes, 64);
  EXPECT_EQ(fleet.router.num_offered(Kind::kPacket), 7);
}

TEST(Packet, CountsThoseOutOfRangeTogetherInALargeFleetButNotTheStale) {
  TestFleet fleet(OverTheWater(0));
  fleet.Report("bravo", {99, 0, 0});
  fleet.Report("charlie", {5000, 0, 0});
  fleet.Report("delta", {0, 5000, 0});
  fleet.utime = 50 * kSecond_us;
  fleet.Report("alpha", {0, 0, 0});
  const Fates fates = SendPacket(&fleet, "alpha");
  ASSERT_EQ(fates.size(), 2U);
  EXPECT_EQ(fates.at("bravo").cause, Cause::kInTransit);
  EXPECT_EQ(fates.at("*").cause, Cause::kOutOfRange);
  EXPECT_EQ(fates.at("*").count, 2);
  EXPECT_EQ(fates.at("*").kind, Kind::kPacket);
}

TEST(OverTheWater, WhatTheRulesLetPassIsInTransit) {
  TestFleet fleet(OverTheWater());
  fleet.Report("alpha", {0, 0, 0});
  EXPECT_EQ(fleet.Report("bravo", {50, 0, 0}).at("alpha").cause, Cause::kInTransit);
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kInTransit);
  EXPECT_EQ(fleet.Ack("bravo", "alpha").cause, Cause::kInTransit);
  EXPECT_EQ(fleet.Report("charlie", {5000, 0, 0}).at("alpha").cause, Cause::kOutOfRange);
}

TEST(OverTheWater, ReportsAndMessagesAreChosenEachForItself) {
  RoutingRules rules;
  rules.reports_over = Over("acoustic");
  TestFleet fleet(rules);
  fleet.Report("alpha", {0, 0, 0});
  EXPECT_EQ(fleet.Report("bravo", {50, 0, 0}).at("alpha").cause, Cause::kInTransit);
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kDelivered);
  EXPECT_EQ(fleet.Ack("bravo", "alpha").cause, Cause::kDelivered);
}

TEST(OverTheWater, TheReportIntervalCountsFromWhatTheRulesLetPass) {
  RoutingRules rules = OverTheWater();
  rules.min_rpt_interval_s = 10;
  TestFleet fleet(rules);
  fleet.Report("alpha", {0, 0, 0});
  EXPECT_EQ(fleet.Report("bravo", {50, 0, 0}).at("alpha").cause, Cause::kInTransit);
  fleet.utime += kSecond_us;
  EXPECT_EQ(fleet.Report("bravo", {50, 0, 0}).at("alpha").cause, Cause::kTooSoon);
}

TEST(Conclude, MovesTheCountOfEveryVehicleConcerned) {
  TestFleet fleet(OverTheWater());
  fleet.Report("alpha", {0, 0, 0});
  const Decision pending = fleet.Report("bravo", {50, 0, 0}).at("alpha");
  const Decision concluded = fleet.router.Conclude(pending, "bravo", "alpha", Cause::kCollision);
  EXPECT_EQ(concluded.cause, Cause::kCollision);
  EXPECT_EQ(concluded.range_m, 50);
  for (const CauseCounts* counts : {&fleet.router.counts(Kind::kReport), &fleet.At("bravo").sent[0],
                                    &fleet.At("alpha").received[0]}) {
    EXPECT_EQ(CountOf(*counts, Cause::kInTransit), 0);
    EXPECT_EQ(CountOf(*counts, Cause::kCollision), 1);
    EXPECT_EQ(Total(*counts), 1);
  }
}

TEST(Conclude, LeavesOthersThatHaveTakenTheNameAlone) {
  TestFleet fleet(OverTheWater(), 1, {"alpha"});
  fleet.Report("alpha", {0, 0, 0});
  const Decision pending = fleet.Report("nemo", {50, 0, 0}).at("alpha");
  fleet.utime += 1000 * kSecond_us;
  fleet.router.ForgetSilent(fleet.utime);
  fleet.Report("alpha", {0, 0, 0});
  for (int i = 0; i < Router::kMaxUnregistered; ++i) {
    fleet.Report("other" + std::to_string(i), {0, 5000, 0});
  }
  EXPECT_EQ(fleet.At("nemo").key, "") << "gone";
  fleet.router.Conclude(pending, "nemo", "alpha", Cause::kDelivered);
  EXPECT_EQ(CountOf(fleet.At("alpha").received[0], Cause::kDelivered), 1);
}

RC_GTEST_PROP(OverTheWater, FatesAndWhatIsInTransitAreWhatWasOffered, (uint64_t seed)) {
  RandomTraffic traffic(seed, {"alpha", "bravo", "charlie", "nemo"});
  TestFleet fleet(OverTheWater(), 1);
  std::vector<std::pair<Decision, std::string>> in_transit;
  int64_t num_packet_fates = 0;
  for (int i = 0; i < 60; ++i) {
    fleet.utime += traffic.Pause_us();
    RoutingRules rules = traffic.Rules();
    rules.reports_over = traffic.dice.Pick<MediaChoice>({Over("direct"), Over("acoustic")});
    rules.each_fate_up_to = traffic.dice.Pick<int64_t>({0, 1000});
    if (traffic.dice.OneIn(10)) fleet.router.SetRules(rules);
    const RandomReport report = traffic.Report();
    Fates fates = fleet.Report(report.name, report.position_m, report.group);
    const Fates packets = SendPacket(&fleet, traffic.Name());
    for (const auto& [name, decision] : packets) {
      num_packet_fates += decision.count;
      fates.emplace(name + " packet", decision);
    }
    for (const auto& [name, decision] : fates) {
      if (decision.cause != Cause::kInTransit) continue;
      in_transit.emplace_back(decision, fleet.router.contact(decision.destination).name);
    }
    while (!in_transit.empty() && traffic.dice.OneIn(2)) {
      const auto [decision, name] = in_transit.back();
      in_transit.pop_back();
      fleet.router.Conclude(decision, fleet.router.contact(decision.source).name, name,
                            traffic.dice.Pick<Cause>({Cause::kDelivered, Cause::kCollision}));
    }
    RC_ASSERT(Total(fleet.router.counts(Kind::kPacket)) == num_packet_fates);
    RC_ASSERT(CountOf(fleet.router.counts(Kind::kPacket), Cause::kInTransit) +
                  CountOf(fleet.router.counts(Kind::kReport), Cause::kInTransit) ==
              static_cast<int64_t>(in_transit.size()));
    for (const Contact* contact : fleet.router.contacts()) {
      for (const int64_t count : contact->received[3]) RC_ASSERT(count >= 0);
    }
  }
}

}  // namespace shoal::acoustic_routing_test
