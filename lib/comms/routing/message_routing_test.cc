// Node messages and acks: intervals, lengths, addresses, groups.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "lib/comms/routing/fleet_testing.h"

namespace shoal::message_routing_test {

/// alpha, bravo and charlie within 50 m of each other, all fresh and never stale.
TestFleet MakeFleet(double min_msg_interval_s = -1) {
  RoutingRules rules;
  rules.stale_time_s = -1;
  rules.min_msg_interval_s = min_msg_interval_s;
  return TestFleet(rules);
}

void ReportAll(TestFleet* fleet) {
  fleet->Report("alpha", {0, 0, 0});
  fleet->Report("bravo", {50, 0, 0});
  fleet->Report("charlie", {0, 50, 0});
}

// The manual, section 4.2: an interval of 60 s.
TEST(MinMsgInterval, LetsAMessage62SecondsAfterTheLastThroughWhateverWasTriedAfter58) {
  TestFleet fleet = MakeFleet(60);
  ReportAll(&fleet);
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kDelivered);
  fleet.utime = 58 * kSecond_us;
  const Decision early = fleet.Message("alpha", "bravo").at("bravo");
  EXPECT_EQ(early.cause, Cause::kTooSoon);
  EXPECT_EQ(early.wait_s, 2);
  fleet.utime = 62 * kSecond_us;
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kDelivered);
}

// The same example, continued: a failed attempt costs another 60 s, whatever made it fail.
TEST(MinMsgInterval, IsRestartedByEveryMessageThatFailedForAnotherReason) {
  struct Attempt {
    MessageFacts message;
    std::string destination;
    Cause cause;
  };
  const std::vector<Attempt> attempts = {
      {{.source = "alpha", .dest_node = "nemo"}, "nemo", Cause::kUnknownDestination},
      {{.source = "alpha", .dest_node = "bravo", .length_bytes = 1001}, "bravo", Cause::kTooLong},
      {{.source = "alpha", .dest_node = "charlie"}, "charlie", Cause::kOutOfRange},
      {{.source = "alpha", .dest_group = "unused_group"}, "", Cause::kNoDestination}};
  for (const Attempt& attempt : attempts) {
    TestFleet fleet = MakeFleet(60);
    ReportAll(&fleet);
    fleet.Report("charlie", {5000, 0, 0});
    fleet.Message("alpha", "bravo");
    fleet.utime = 62 * kSecond_us;
    EXPECT_EQ(fleet.Message(attempt.message).at(attempt.destination).cause, attempt.cause);
    fleet.utime = 121 * kSecond_us;
    EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kTooSoon);
    fleet.utime = 122 * kSecond_us;
    EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kDelivered);
  }
}

TEST(MinMsgInterval, IsRestartedByAMessageOfAVehicleThatIsNotKnownYet) {
  TestFleet fleet = MakeFleet(60);
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kUnknownSource);
  ReportAll(&fleet);
  fleet.utime = 59 * kSecond_us;
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kTooSoon);
}

TEST(MinMsgInterval, IsNotTouchedByAnInvalidMessage) {
  TestFleet fleet = MakeFleet(60);
  ReportAll(&fleet);
  const MessageFacts bad = {.source = "alpha", .dest_node = "bravo", .is_sound = false};
  EXPECT_EQ(fleet.Message(bad).at("").cause, Cause::kInvalid);
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kDelivered);
  EXPECT_EQ(fleet.Message(bad).at("").cause, Cause::kInvalid) << "invalid comes before too soon";
}

TEST(MinMsgInterval, HoldsJustBeforeItsEndAndNotAtIt) {
  for (const int64_t elapsed_us : {29'999'999, 30'000'000, 30'000'001}) {
    TestFleet fleet = MakeFleet(30);
    ReportAll(&fleet);
    fleet.Message("alpha", "bravo");
    fleet.utime = elapsed_us;
    EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause,
              elapsed_us < 30'000'000 ? Cause::kTooSoon : Cause::kDelivered);
  }
}

TEST(MinMsgInterval, IsEachSourcesOwn) {
  TestFleet fleet = MakeFleet(60);
  ReportAll(&fleet);
  fleet.Message("alpha", "bravo");
  EXPECT_EQ(fleet.Message("bravo", "alpha").at("alpha").cause, Cause::kDelivered);
  EXPECT_EQ(fleet.Message("ALPHA", "charlie").at("charlie").cause, Cause::kTooSoon);
}

TEST(MinMsgInterval, IsOffWhereNegativeOrZero) {
  for (const double off : {-1.0, 0.0}) {
    TestFleet fleet = MakeFleet(off);
    ReportAll(&fleet);
    fleet.Message("alpha", "bravo");
    EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kDelivered);
  }
}

Decision MessageOfLength(int64_t length_bytes, int64_t max_msg_length_bytes) {
  TestFleet fleet = MakeFleet();
  RoutingRules rules = fleet.router.rules();
  rules.max_msg_length_bytes = max_msg_length_bytes;
  fleet.router.SetRules(rules);
  ReportAll(&fleet);
  return fleet.Message({.source = "alpha", .dest_node = "bravo", .length_bytes = length_bytes})
      .at("bravo");
}

TEST(MaxMsgLength, LetsAMessageOfEqualLengthThroughAndStopsALongerOne) {
  EXPECT_EQ(MessageOfLength(999, 1000).cause, Cause::kDelivered);
  EXPECT_EQ(MessageOfLength(1000, 1000).cause, Cause::kDelivered);
  const Decision decision = MessageOfLength(1001, 1000);
  EXPECT_EQ(decision.cause, Cause::kTooLong);
  EXPECT_EQ(decision.length_bytes, 1001);
  EXPECT_EQ(decision.length_limit_bytes, 1000);
}

TEST(MaxMsgLength, IsUnlimitedWhereZero) {
  const Decision decision = MessageOfLength(std::numeric_limits<int64_t>::max(), 0);
  EXPECT_EQ(decision.cause, Cause::kDelivered);
  EXPECT_EQ(decision.length_limit_bytes, -1);
}

TEST(MessageOrder, IsTooSoonTooLongUnknownSourceThenTheDestinations) {
  TestFleet fleet;  // The manual's defaults.
  const MessageFacts long_one = {.source = "alpha", .dest_node = "bravo", .length_bytes = 1001};
  EXPECT_EQ(fleet.Message(long_one).at("bravo").cause, Cause::kTooLong) << "before unknown source";
  EXPECT_EQ(fleet.Message(long_one).at("bravo").cause, Cause::kTooSoon) << "before too long";
  EXPECT_EQ(fleet.Message(long_one).at("bravo").length_bytes, -1) << "the length was not asked";
  fleet.utime = 30 * kSecond_us;
  EXPECT_EQ(fleet.Message("alpha", "bravo:nemo").at("nemo").cause, Cause::kUnknownSource)
      << "before unknown destination";
  fleet.Report("alpha", {0, 0, 0});
  fleet.utime = 60 * kSecond_us;
  EXPECT_EQ(fleet.Message("alpha", "nemo").at("nemo").cause, Cause::kUnknownDestination);
}

// Section 2.1 of the manual is about the recipient alone: a vehicle whose reporter is quieter than
// stale_time can send, from where its last report put it, until it is forgotten.
TEST(StaleSource, SendsMessagesAndAcksUntilItIsForgotten) {
  TestFleet fleet;
  fleet.ChangeRules([](RoutingRules* rules) { rules->min_msg_interval_s = -1; });
  fleet.Report("alpha", {0, 0, 0});
  for (const int64_t age_us : {4'999'999, 5'000'000, 99'999'999}) {
    fleet.utime = age_us;
    fleet.Report("bravo", {50, 0, 0});
    EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kDelivered) << age_us;
    EXPECT_EQ(fleet.Ack("alpha", "bravo").cause, Cause::kDelivered) << age_us;
  }
  fleet.Report("bravo", {150, 0, 0});
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kOutOfRange);
  fleet.utime = 100 * kSecond_us;
  fleet.router.ForgetSilent(fleet.utime, nullptr);
  fleet.Report("bravo", {50, 0, 0});
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kUnknownSource);
  EXPECT_EQ(fleet.Ack("alpha", "bravo").cause, Cause::kUnknownSource);
}

TEST(MsgGroups, StopMessagesToOtherGroupsBeforeStalenessIsAsked) {
  TestFleet fleet;
  fleet.ChangeRules([](RoutingRules* rules) { rules->msg_groups = true; });
  fleet.Report("bravo", {50, 0, 0}, "blue");
  fleet.utime = 5 * kSecond_us;
  fleet.Report("alpha", {0, 0, 0}, "red");
  fleet.Report("charlie", {0, 50, 0}, "RED");
  const Fates fates = fleet.Message("alpha", "all");
  EXPECT_EQ(fates.at("bravo").cause, Cause::kOtherGroup);
  EXPECT_EQ(fates.at("charlie").cause, Cause::kDelivered);
}

TEST(MsgGroups, CountVehiclesWithoutGroupAsOne) {
  TestFleet fleet = MakeFleet();
  fleet.ChangeRules([](RoutingRules* rules) { rules->msg_groups = true; });
  ReportAll(&fleet);
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kDelivered);
}

TEST(Acks, AskRangeStalenessAndDropButNoIntervalAndNoGroups) {
  TestFleet fleet(RoutingRules{});
  ReportAll(&fleet);
  EXPECT_EQ(fleet.Ack("bravo", "alpha").cause, Cause::kDelivered);
  EXPECT_EQ(fleet.Ack("bravo", "alpha").cause, Cause::kDelivered) << "30 s are for messages";
  EXPECT_EQ(fleet.Ack("bravo", "alpha").number, 2);
  fleet.Report("alpha", {150, 0, 0});
  EXPECT_EQ(fleet.Ack("bravo", "alpha").cause, Cause::kOutOfRange);
  fleet.utime = 5 * kSecond_us;
  fleet.Report("bravo", {50, 0, 0});
  EXPECT_EQ(fleet.Ack("bravo", "alpha").cause, Cause::kStaleReceiver);
  fleet.Report("alpha", {0, 0, 0});
  fleet.ChangeRules([](RoutingRules* rules) { rules->drop_percentage = 100; });
  EXPECT_EQ(fleet.Ack("bravo", "alpha").cause, Cause::kDropped);
}

// alpha changes its group between its message and the ack.
TEST(Acks, PassBetweenThePartiesOfAMessageThatPassed) {
  TestFleet fleet = MakeFleet();
  fleet.ChangeRules([](RoutingRules* rules) { rules->msg_groups = true; });
  fleet.Report("alpha", {0, 0, 0}, "red");
  fleet.Report("bravo", {50, 0, 0}, "red");
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kDelivered);
  fleet.Report("alpha", {0, 0, 0}, "blue");
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kOtherGroup);
  EXPECT_EQ(fleet.Ack("bravo", "alpha").cause, Cause::kDelivered);
}

TEST(Acks, DoNotTouchTheIntervalOfMessages) {
  TestFleet fleet(RoutingRules{});
  ReportAll(&fleet);
  fleet.Message("alpha", "bravo");
  EXPECT_EQ(fleet.Ack("alpha", "bravo").cause, Cause::kDelivered);
  fleet.utime = 30 * kSecond_us;
  ReportAll(&fleet);
  EXPECT_EQ(fleet.Message("alpha", "bravo").at("bravo").cause, Cause::kDelivered);
}

TEST(Acks, NeedBothEndsKnownAndDifferent) {
  TestFleet fleet(RoutingRules{});
  EXPECT_EQ(fleet.Ack("alpha", "bravo").cause, Cause::kUnknownSource);
  EXPECT_EQ(fleet.Ack("nemo", "bravo").cause, Cause::kUnknownSource);
  fleet.Report("alpha", {0, 0, 0});
  EXPECT_EQ(fleet.Ack("alpha", "bravo").cause, Cause::kUnknownDestination);
  EXPECT_EQ(fleet.Ack("alpha", "nemo").cause, Cause::kUnknownDestination);
  EXPECT_EQ(fleet.Ack("alpha", "nemo").unknown_name, 0);
  EXPECT_EQ(fleet.Ack("alpha", "ALPHA").cause, Cause::kInvalid);
  EXPECT_EQ(fleet.Ack("alpha", "all").cause, Cause::kInvalid);
  EXPECT_EQ(fleet.Ack("", "alpha").cause, Cause::kInvalid);
  EXPECT_EQ(fleet.Ack("alpha", "bravo", false).cause, Cause::kInvalid);
  EXPECT_EQ(fleet.router.contacts().size(), 3U) << "an ack makes no vehicle known";
  EXPECT_EQ(Total(fleet.router.counts(Kind::kAck)), 9);
}

}  // namespace shoal::message_routing_test
