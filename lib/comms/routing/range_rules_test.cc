// The rules that ask where a vehicle is and how old that is, for reports and messages.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/base/time/seconds.h"
#include "lib/comms/routing/decide_testing.h"

namespace shoal::range_rules_test {

constexpr int64_t kNow = 1'000'000'000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Eigen::Vector3d kFarAway_m(1e6, 0, 0);

Contact ReceiverAt(const Eigen::Vector3d& position_m, int64_t age_us = 0) {
  Contact receiver;
  receiver.position_m = position_m;
  receiver.received_utime = kNow - age_us;
  return receiver;
}

/// Decides on a report from the origin.
Decision Report(const RoutingRules& rules, const Contact& receiver,
                const Transmission& report = {}) {
  return DecideReport(rules, report, receiver, kNever, false, kNow);
}

Decision Message(const RoutingRules& rules, const Contact& receiver,
                 const Transmission& message = {}) {
  return DecideMessage(rules, message, receiver, kNow);
}

RoutingRules RangeOnly(double comms_range_m) {
  return {.comms_range_m = comms_range_m, .critical_range_m = 0};
}

TEST(Defaults, AreTheManuals) {
  const RoutingRules rules;
  EXPECT_EQ(rules.comms_range_m, 100);
  EXPECT_EQ(rules.critical_range_m, 30);
  EXPECT_EQ(rules.stale_time_s, 5);
  EXPECT_EQ(rules.stale_forget_s, 20 * rules.stale_time_s);
  EXPECT_FALSE(rules.groups);
  EXPECT_FALSE(rules.msg_groups);
  EXPECT_EQ(rules.ignore_group, "");
  EXPECT_LT(rules.min_rpt_interval_s, 0);
  EXPECT_EQ(rules.min_msg_interval_s, 30);
  EXPECT_EQ(rules.max_msg_length_bytes, 1000);
  EXPECT_EQ(rules.drop_percentage, 0);
  EXPECT_LT(rules.shared_node_reports_s, 0);
  EXPECT_EQ(rules.pulse_duration_s, 10);
  EXPECT_TRUE(rules.view_node_rpt_pulses);
  EXPECT_EQ(rules.msg_color, "white");
  EXPECT_EQ(rules.msg_repeat_color, "light_green");
  EXPECT_EQ(kSharedReportsInterval_s, 0.1);
}

TEST(Defaults, GiveNoVehicleStealthOrEarange) {
  EXPECT_EQ(LinkFactors().stealth, 1);
  EXPECT_EQ(LinkFactors().earange, 1);
}

TEST(CommsRange, LetsThroughJustInside) {
  const Contact receiver = ReceiverAt({std::nextafter(250, 0), 0, 0});
  EXPECT_EQ(Report(RangeOnly(250), receiver).cause, Cause::kDelivered);
  EXPECT_EQ(Message(RangeOnly(250), receiver).cause, Cause::kDelivered);
}

TEST(CommsRange, StopsWhatIsExactlyAtItAndReturnsTheNumbers) {
  for (const Decision& decision : {Report(RangeOnly(250), ReceiverAt({0, -250, 0})),
                                   Message(RangeOnly(250), ReceiverAt({0, -250, 0}))}) {
    EXPECT_EQ(decision.cause, Cause::kOutOfRange);
    EXPECT_EQ(decision.range_m, 250);
    EXPECT_EQ(decision.limit_m, 250);
  }
}

TEST(CommsRange, StopsWhatIsJustOutside) {
  const Contact receiver = ReceiverAt({std::nextafter(250, 300), 0, 0});
  EXPECT_EQ(Report(RangeOnly(250), receiver).cause, Cause::kOutOfRange);
  EXPECT_EQ(Message(RangeOnly(250), receiver).cause, Cause::kOutOfRange);
}

TEST(CommsRange, CountsTheDepth) {
  const Contact receiver = ReceiverAt({2, 3, 6});
  EXPECT_EQ(Report(RangeOnly(7), receiver).cause, Cause::kOutOfRange);
  EXPECT_EQ(Report(RangeOnly(7.001), receiver).cause, Cause::kDelivered);
  EXPECT_EQ(Message(RangeOnly(7), receiver).cause, Cause::kOutOfRange);
  EXPECT_EQ(Message(RangeOnly(7.001), receiver).cause, Cause::kDelivered);
}

TEST(CommsRange, HasNoLimitWhereNegative) {
  for (const Decision& decision : {Report(RangeOnly(-1), ReceiverAt(kFarAway_m)),
                                   Message(RangeOnly(-1e-9), ReceiverAt(kFarAway_m))}) {
    EXPECT_EQ(decision.cause, Cause::kDelivered);
    EXPECT_EQ(decision.range_m, 1e6);
    EXPECT_EQ(decision.limit_m, -1);
  }
}

TEST(CommsRange, LetsNothingThroughWhereZero) {
  EXPECT_EQ(Report(RangeOnly(0), ReceiverAt({0, 0, 0})).cause, Cause::kOutOfRange);
  EXPECT_EQ(Message(RangeOnly(0), ReceiverAt({0, 0, 0})).cause, Cause::kOutOfRange);
}

TEST(CommsRange, StandsDistancesBeyondAllNumbers) {
  const Decision decision = Report(RangeOnly(100), ReceiverAt({1e308, -1e308, 1e308}));
  EXPECT_EQ(decision.cause, Cause::kOutOfRange);
  EXPECT_EQ(decision.range_m, kInfinity);
}

TEST(Stealth, ShortensTheRangeAtWhichTheSourceIsReceived) {
  Transmission report;
  report.stealth = 0.5;
  EXPECT_EQ(Report(RangeOnly(100), ReceiverAt({49.999, 0, 0}), report).cause, Cause::kDelivered);
  const Decision decision = Report(RangeOnly(100), ReceiverAt({50, 0, 0}), report);
  EXPECT_EQ(decision.cause, Cause::kOutOfRange);
  EXPECT_EQ(decision.limit_m, 50);
  EXPECT_EQ(Message(RangeOnly(100), ReceiverAt({50, 0, 0}), report).cause, Cause::kOutOfRange);
}

TEST(Stealth, OfZeroReachesNoVehicleOutsideTheCriticalRange) {
  Transmission report;
  report.stealth = 0;
  EXPECT_EQ(Report(RangeOnly(100), ReceiverAt({0, 0, 0}), report).cause, Cause::kOutOfRange);
  EXPECT_EQ(Report({}, ReceiverAt({29, 0, 0}), report).cause, Cause::kDelivered);
}

TEST(Earange, LengthensTheRangeAtWhichTheReceiverReceives) {
  Contact receiver = ReceiverAt({999.999, 0, 0});
  receiver.factors.earange = 10;
  EXPECT_EQ(Report(RangeOnly(100), receiver).cause, Cause::kDelivered);
  EXPECT_EQ(Message(RangeOnly(100), receiver).cause, Cause::kDelivered);
  receiver.position_m.x() = 1000;
  EXPECT_EQ(Report(RangeOnly(100), receiver).cause, Cause::kOutOfRange);
  EXPECT_EQ(Message(RangeOnly(100), receiver).limit_m, 1000);
}

TEST(Earange, AndStealthCancelEachOther) {
  Transmission report;
  report.stealth = 0.5;
  Contact receiver = ReceiverAt({99.999, 0, 0});
  receiver.factors.earange = 2;
  EXPECT_EQ(Report(RangeOnly(100), receiver, report).cause, Cause::kDelivered);
  receiver.position_m.x() = 100;
  EXPECT_EQ(Report(RangeOnly(100), receiver, report).cause, Cause::kOutOfRange);
}

TEST(Earange, OfTheSourceDoesNotMatterNorStealthOfTheReceiver) {
  Contact receiver = ReceiverAt({60, 0, 0});
  receiver.factors.stealth = 0.1;
  EXPECT_EQ(Report(RangeOnly(100), receiver).cause, Cause::kDelivered);
}

TEST(CriticalRange, LetsReportsThroughJustInsideAndReportsSo) {
  const RoutingRules rules = {.comms_range_m = 0, .critical_range_m = 30};
  const Decision decision = Report(rules, ReceiverAt({std::nextafter(30, 0), 0, 0}));
  EXPECT_EQ(decision.cause, Cause::kDelivered);
  EXPECT_EQ(decision.override_rule, OverrideRule::kCriticalRange);
  EXPECT_EQ(decision.limit_m, 30);
}

TEST(CriticalRange, DoesNotHoldAtItNorOutside) {
  const RoutingRules rules = {.comms_range_m = 0, .critical_range_m = 30};
  EXPECT_EQ(Report(rules, ReceiverAt({30, 0, 0})).cause, Cause::kOutOfRange);
  EXPECT_EQ(Report(rules, ReceiverAt({std::nextafter(30, 31), 0, 0})).cause, Cause::kOutOfRange);
}

TEST(CriticalRange, CountsTheDepth) {
  const RoutingRules rules = {.comms_range_m = 0, .critical_range_m = 30};
  EXPECT_EQ(Report(rules, ReceiverAt({29, 0, 29})).cause, Cause::kOutOfRange);
}

TEST(CriticalRange, OverridesAllRulesButStaleness) {
  RoutingRules rules = {.comms_range_m = 0, .critical_range_m = 30};
  rules.groups = true;
  rules.drop_percentage = 100;
  rules.min_rpt_interval_s = 60;
  Transmission report;
  report.stealth = 0;
  report.group_key = "red";
  report.link_key = DropKey(1, Kind::kReport, "alpha");
  const auto decide = [&](int64_t age_us) {
    return DecideReport(rules, report, ReceiverAt({1, 0, 0}, age_us), kNow - 1, false, kNow);
  };
  EXPECT_EQ(decide(0).override_rule, OverrideRule::kCriticalRange);
  EXPECT_EQ(decide(0).cause, Cause::kDelivered);
  EXPECT_EQ(decide(5'000'000).cause, Cause::kStaleReceiver);
  EXPECT_EQ(decide(5'000'000).override_rule, OverrideRule::kNone);
}

TEST(CriticalRange, DoesNothingForMessages) {
  const Decision decision =
      Message({.comms_range_m = 10, .critical_range_m = 30}, ReceiverAt({11, 0, 0}));
  EXPECT_EQ(decision.cause, Cause::kOutOfRange);
  EXPECT_EQ(decision.override_rule, OverrideRule::kNone);
}

TEST(CriticalRange, OfZeroLetsNothingThrough) {
  EXPECT_EQ(Report({.comms_range_m = 0, .critical_range_m = 0}, ReceiverAt({0, 0, 0})).cause,
            Cause::kOutOfRange);
}

TEST(StaleTime, LetsThroughToAVehicleJustYounger) {
  for (const Decision& decision : {Report(RangeOnly(100), ReceiverAt({1, 0, 0}, 4'999'999)),
                                   Message(RangeOnly(100), ReceiverAt({1, 0, 0}, 4'999'999))}) {
    EXPECT_EQ(decision.cause, Cause::kDelivered);
    EXPECT_EQ(decision.age_s, 4.999999);
    EXPECT_EQ(decision.age_limit_s, 5);
  }
}

TEST(StaleTime, StopsWhatIsForAVehicleExactlyAsOldOrOlder) {
  for (const int64_t age_us : {5'000'000, 5'000'001}) {
    for (const Decision& decision : {Report(RangeOnly(100), ReceiverAt({1, 0, 0}, age_us)),
                                     Message(RangeOnly(100), ReceiverAt({1, 0, 0}, age_us))}) {
      EXPECT_EQ(decision.cause, Cause::kStaleReceiver);
      EXPECT_EQ(decision.age_s, Seconds(age_us));
      EXPECT_EQ(decision.range_m, -1) << "the range was not asked";
    }
  }
}

TEST(StaleTime, NeverHoldsWhereNegative) {
  RoutingRules rules = RangeOnly(100);
  rules.stale_time_s = -1;
  for (const Decision& decision :
       {Report(rules, ReceiverAt({1, 0, 0}, kNow)), Message(rules, ReceiverAt({1, 0, 0}, kNow))}) {
    EXPECT_EQ(decision.cause, Cause::kDelivered);
    EXPECT_EQ(decision.age_limit_s, -1);
  }
  EXPECT_FALSE(IsStale(rules, 0, kNow));
}

TEST(StaleTime, AlwaysHoldsWhereZero) {
  RoutingRules rules = RangeOnly(100);
  rules.stale_time_s = 0;
  EXPECT_EQ(Report(rules, ReceiverAt({1, 0, 0})).cause, Cause::kStaleReceiver);
  EXPECT_EQ(Message(rules, ReceiverAt({1, 0, 0})).cause, Cause::kStaleReceiver);
  EXPECT_TRUE(IsStale(rules, kNow, kNow));
}

}  // namespace shoal::range_rules_test
