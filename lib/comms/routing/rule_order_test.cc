// Which rule is the cause where several stop a transmission.
#include <gtest/gtest.h>

#include <functional>
#include <string_view>
#include <vector>

#include "lib/comms/routing/decide_testing.h"

namespace shoal::rule_order_test {

constexpr int64_t kNow = 1'000'000'000;

/// A link that every rule stops.
struct Link {
  RoutingRules rules = {.comms_range_m = 10, .critical_range_m = 5};
  Transmission sent;
  Contact receiver;
  int64_t delivered_utime = kNow - 1;
  bool is_wanted = false;

  Link() {
    rules.groups = true;
    rules.msg_groups = true;
    rules.drop_percentage = 100;
    rules.min_rpt_interval_s = 60;
    sent.group_key = "red";
    sent.link_key = DropKey(1, Kind::kReport, "alpha");
    receiver.key = "bravo";
    receiver.group_key = "blue";
    receiver.position_m = {10, 0, 0};
    receiver.received_utime = kNow - 5'000'000;
  }

  Decision Report() const {
    return DecideReport(rules, sent, receiver, delivered_utime, is_wanted, kNow);
  }
  Decision Message() const { return DecideMessage(rules, sent, receiver, kNow); }
};

TEST(OrderOfRules, ForAReportIsStaleRangeGroupsDropInterval) {
  Link link;
  EXPECT_EQ(link.Report().cause, Cause::kStaleReceiver);
  link.receiver.received_utime = kNow;
  EXPECT_EQ(link.Report().cause, Cause::kOutOfRange);
  link.receiver.position_m.x() = 9;
  EXPECT_EQ(link.Report().cause, Cause::kOtherGroup);
  link.receiver.group_key = "red";
  EXPECT_EQ(link.Report().cause, Cause::kDropped);
  link.rules.drop_percentage = 0;
  EXPECT_EQ(link.Report().cause, Cause::kTooSoon);
  link.delivered_utime = kNever;
  EXPECT_EQ(link.Report().cause, Cause::kDelivered);
  EXPECT_EQ(link.Report().override_rule, OverrideRule::kNone);
}

TEST(OrderOfRules, ForAReportBeginsWithTheRequestForIt) {
  Link link;
  link.is_wanted = true;
  const Decision decision = link.Report();
  EXPECT_EQ(decision.cause, Cause::kDelivered);
  EXPECT_EQ(decision.override_rule, OverrideRule::kFullReport);
  EXPECT_EQ(decision.range_m, 10);
  EXPECT_EQ(decision.age_s, 5);
  EXPECT_EQ(decision.limit_m, -1) << "no limit was asked";
  EXPECT_EQ(decision.age_limit_s, -1);
}

TEST(OrderOfRules, ForAReportAsksCriticalRangeAfterStalenessAndBeforeTheRest) {
  Link link;
  link.receiver.position_m.x() = 4;
  EXPECT_EQ(link.Report().cause, Cause::kStaleReceiver);
  link.receiver.received_utime = kNow;
  EXPECT_EQ(link.Report().cause, Cause::kDelivered);
}

TEST(OrderOfRules, ForAMessageIsGroupStaleRangeDrop) {
  Link link;
  EXPECT_EQ(link.Message().cause, Cause::kOtherGroup);
  link.receiver.group_key = "red";
  EXPECT_EQ(link.Message().cause, Cause::kStaleReceiver);
  link.receiver.received_utime = kNow;
  EXPECT_EQ(link.Message().cause, Cause::kOutOfRange);
  link.receiver.position_m.x() = 9;
  EXPECT_EQ(link.Message().cause, Cause::kDropped);
  link.rules.drop_percentage = 0;
  EXPECT_EQ(link.Message().cause, Cause::kDelivered) << "min_rpt_interval is for reports";
}

TEST(OrderOfRules, LeavesTheNumbersOfRulesThatWereNotAskedOut) {
  const Decision decision = Link().Report();
  EXPECT_EQ(decision.age_s, 5);
  EXPECT_EQ(decision.age_limit_s, 5);
  EXPECT_EQ(decision.range_m, -1);
  EXPECT_EQ(decision.limit_m, -1);
  EXPECT_EQ(decision.loss_pct, -1);
  EXPECT_EQ(decision.wait_s, -1);
}

TEST(OrderOfRules, ReturnsTheNumbersOfAllRulesThatWereAsked) {
  Link link;
  link.receiver.received_utime = kNow - 1'000'000;
  link.receiver.position_m.x() = 9;
  link.receiver.group_key = "red";
  link.rules.drop_percentage = 1e-9;
  const Decision decision = link.Report();
  EXPECT_EQ(decision.cause, Cause::kTooSoon);
  EXPECT_EQ(decision.age_s, 1);
  EXPECT_EQ(decision.range_m, 9);
  EXPECT_EQ(decision.limit_m, 10);
  EXPECT_EQ(decision.loss_pct, 1e-9);
  EXPECT_DOUBLE_EQ(decision.wait_s, 59.999999);
}

TEST(Groups, KeepReportsWithinOneGroup) {
  RoutingRules rules;
  rules.groups = true;
  Transmission report;
  Contact receiver;
  receiver.position_m = {50, 0, 0};
  receiver.received_utime = kNow;
  const auto cause = [&](std::string_view from, std::string_view to) {
    report.group_key = from;
    receiver.group_key = to;
    return DecideReport(rules, report, receiver, kNever, false, kNow).cause;
  };
  EXPECT_EQ(cause("red", "red"), Cause::kDelivered);
  EXPECT_EQ(cause("red", "blue"), Cause::kOtherGroup);
  EXPECT_EQ(cause("red", ""), Cause::kOtherGroup);
  EXPECT_EQ(cause("", "red"), Cause::kOtherGroup);
  EXPECT_EQ(cause("", ""), Cause::kDelivered) << "two without a group count as one group";
}

TEST(Groups, DoNotTouchMessagesAndMsgGroupsDoNotTouchReports) {
  RoutingRules rules;
  Transmission sent;
  sent.group_key = "red";
  Contact receiver;
  receiver.group_key = "blue";
  receiver.position_m = {50, 0, 0};
  receiver.received_utime = kNow;
  rules.groups = true;
  EXPECT_EQ(DecideMessage(rules, sent, receiver, kNow).cause, Cause::kDelivered);
  rules.groups = false;
  rules.msg_groups = true;
  EXPECT_EQ(DecideMessage(rules, sent, receiver, kNow).cause, Cause::kOtherGroup);
  EXPECT_EQ(DecideReport(rules, sent, receiver, kNever, false, kNow).cause, Cause::kDelivered);
}

}  // namespace shoal::rule_order_test
