// What RuleSequence derives from made-up rules: no rule before the range can be missed where far
// receivers are counted together.
#include "lib/comms/routing/rule_sequence.h"

#include <gtest/gtest.h>

#include <vector>

namespace shoal::rule_sequence_test {

struct StopsFar {
  static constexpr Cause kCause = Cause::kOutOfRange;
  static constexpr Scope kScope = Scope::kFar;
  static bool IsOn(const RoutingRules& rules) { return rules.comms_range_m >= 0; }
  static double Reach_m(const RoutingRules& rules, double stealth, double earange) {
    return rules.comms_range_m * stealth * earange;
  }
};

/// On while drop_percentage is.
struct LooksAtTheLink {
  static constexpr Cause kCause = Cause::kDropped;
  static constexpr Scope kScope = Scope::kLink;
  static bool IsOn(const RoutingRules& rules) { return rules.drop_percentage > 0; }
  static Answer Ask(const LinkFacts& link, Decision*) {
    return link.sent.position_m.z() > 0 ? Answer::kStops : Answer::kNext;
  }
};

/// Stops at receivers at a depth of 10 m and more.
struct LooksAtTheReceiver {
  static constexpr Cause kCause = Cause::kOtherGroup;
  static constexpr Scope kScope = Scope::kReceiver;
  static bool StopsAt(const RoutingRules&, const Contact& receiver, int64_t, Decision*) {
    return receiver.position_m.z() >= 10;
  }
  static void FillLimits(const RoutingRules&, Decision* decision) { decision->wait_s = 10; }
};

struct DeliversNear {
  static constexpr Cause kCause = Cause::kDelivered;
  static constexpr Scope kScope = Scope::kNear;
  static double Reach_m(const RoutingRules& rules) { return rules.critical_range_m; }
  static Answer AskNear(const LinkFacts&, double, Decision*) { return Answer::kDelivers; }
};

Contact ReceiverAtDepth(double depth_m) {
  Contact receiver;
  receiver.position_m.z() = depth_m;
  return receiver;
}

TEST(RuleSequence, CountsNoFarReceiverWhereNoRuleStopsThemAll) {
  using Rules = RuleSequence<LooksAtTheReceiver, StopsFar>;
  EXPECT_TRUE(Rules::CountsFar({.comms_range_m = 100}));
  EXPECT_FALSE(Rules::CountsFar({.comms_range_m = -1}));
  EXPECT_FALSE(RuleSequence<LooksAtTheReceiver>::CountsFar({}));
}

TEST(RuleSequence, CountsNoFarReceiverWhileARuleBeforeTheRangeLooksAtTheLink) {
  using Before = RuleSequence<LooksAtTheLink, StopsFar>;
  using Behind = RuleSequence<StopsFar, LooksAtTheLink>;
  RoutingRules rules;
  EXPECT_TRUE(Before::CountsFar(rules));
  rules.drop_percentage = 1;
  EXPECT_FALSE(Before::CountsFar(rules));
  EXPECT_TRUE(Behind::CountsFar(rules)) << "what is too far is not asked for more";
}

TEST(RuleSequence, FindsWhatStopsAtAReceiverBeforeTheRangeOnly) {
  using Before = RuleSequence<LooksAtTheReceiver, StopsFar>;
  using Behind = RuleSequence<StopsFar, LooksAtTheReceiver>;
  EXPECT_EQ(Before::CauseAt({}, ReceiverAtDepth(10), 0), Cause::kOtherGroup);
  EXPECT_EQ(Before::CauseAt({}, ReceiverAtDepth(9), 0), std::nullopt);
  EXPECT_EQ(Behind::CauseAt({}, ReceiverAtDepth(10), 0), std::nullopt);
}

TEST(RuleSequence, ReachesAsFarAsItsFarthestRule) {
  using Rules = RuleSequence<DeliversNear, StopsFar>;
  EXPECT_EQ(Rules::Reach_m({.comms_range_m = 100, .critical_range_m = 30}, 0.5, 4), 200);
  EXPECT_EQ(Rules::Reach_m({.comms_range_m = 100, .critical_range_m = 300}, 0.5, 4), 300);
  EXPECT_EQ(Rules::Reach_m({.comms_range_m = -1, .critical_range_m = 30}, 1, 1), 30);
}

TEST(RuleSequence, ListsTheFatesOfFarReceiversWithTheRangeLast) {
  using Rules = RuleSequence<LooksAtTheReceiver, DeliversNear, StopsFar, LooksAtTheReceiver>;
  std::vector<Decision> fates;
  Rules::EachFarFate({}, 250, [&](const Decision& fate) { fates.push_back(fate); });
  ASSERT_EQ(fates.size(), 2U);
  EXPECT_EQ(fates[0].cause, Cause::kOtherGroup);
  EXPECT_EQ(fates[0].wait_s, 10);
  EXPECT_EQ(fates[0].limit_m, -1);
  EXPECT_EQ(fates[1].cause, Cause::kOutOfRange);
  EXPECT_EQ(fates[1].limit_m, 250);
}

TEST(RuleSequence, DecidesByTheFirstRuleThatStopsOrDelivers) {
  using Rules = RuleSequence<LooksAtTheReceiver, DeliversNear, StopsFar>;
  const Transmission sent;
  const RoutingRules rules = {.comms_range_m = 8, .critical_range_m = 5};
  const auto cause_at = [&](double depth_m) {
    const Contact receiver = ReceiverAtDepth(depth_m);
    return Rules::Decide({.rules = rules, .sent = sent, .receiver = receiver}).cause;
  };
  EXPECT_EQ(cause_at(4), Cause::kDelivered);
  EXPECT_EQ(cause_at(9), Cause::kOutOfRange);
  EXPECT_EQ(cause_at(10), Cause::kOtherGroup);
}

}  // namespace shoal::rule_sequence_test
