// The table of causes, and the texts of kinds and overrides.
#include "lib/comms/routing/cause.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "lib/comms/routing/decide.h"
#include "lib/comms/routing/fate.h"

namespace shoal::cause_test {

constexpr Kind kKinds[] = {Kind::kReport, Kind::kMessage, Kind::kAck, Kind::kPacket};

TEST(Causes, HaveKeysOfTheirOwnLikeOnesInMissionFiles) {
  std::set<std::string_view> keys;
  for (const CauseRow& row : kCauseTable) keys.insert(row.key);
  for (const Kind kind : kKinds) keys.insert(KindText(kind));
  keys.insert(OverrideText(OverrideRule::kCriticalRange));
  keys.insert(OverrideText(OverrideRule::kFullReport));
  EXPECT_EQ(keys.size(), static_cast<size_t>(kNumCauses + kNumKinds + 2));
  for (const std::string_view key : keys) {
    EXPECT_FALSE(key.empty());
    EXPECT_EQ(key.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), key.npos) << key;
  }
  EXPECT_EQ(OverrideText(OverrideRule::kNone), "");
}

TEST(Causes, HaveLabelsAndTextsOfTheirOwnAndColoursInHexadecimal) {
  std::set<std::string_view> labels;
  std::set<std::string_view> texts;
  for (const CauseRow& row : kCauseTable) {
    EXPECT_TRUE(labels.insert(row.label).second) << row.label;
    EXPECT_TRUE(texts.insert(row.text.substr(0, row.text.find(','))).second) << row.text;
    EXPECT_EQ(row.text.substr(0, row.text.find(',')).find('{'), row.text.npos)
        << row.text << ": the name holds no number";
    EXPECT_EQ(row.color.find_first_not_of("0123456789abcdef", 1), row.color.npos) << row.color;
  }
}

TEST(Causes, BelongToTheKindsWhoseRulesAskForThem) {
  const auto count = [](Kind kind) {
    int num = 0;
    for (const CauseRow& row : kCauseTable) num += CanHave(kind, row.cause) ? 1 : 0;
    return num;
  };
  EXPECT_EQ(count(Kind::kReport), 29);
  EXPECT_EQ(count(Kind::kMessage), 29);
  EXPECT_EQ(count(Kind::kAck), 25);
  EXPECT_EQ(count(Kind::kPacket), 20);
  EXPECT_TRUE(CanHave(Kind::kPacket, Cause::kQueueFull)) << "at its own modem";
  EXPECT_FALSE(CanHave(Kind::kPacket, Cause::kStaleReceiver));
  EXPECT_FALSE(CanHave(Kind::kMessage, Cause::kIgnoredGroup));
  EXPECT_FALSE(CanHave(Kind::kAck, Cause::kTooSoon));
}

TEST(Causes, OfTheRulesAtAReceiverCanBeHadByTheirKind) {
  for (const Kind kind : kKinds) {
    for (const Cause cause : OrderOfCauses(kind)) {
      EXPECT_TRUE(RowOf(cause).of_rules.Has(kind)) << KindText(kind) << " " << CauseText(cause);
    }
  }
}

TEST(Causes, StandAtTheirKeys) {
  EXPECT_EQ(CauseText(Cause::kDelivered), "delivered");
  EXPECT_EQ(CauseText(Cause::kTooSoon), "too_soon");
  EXPECT_EQ(CauseText(Cause::kUnknownDestination), "unknown_destination");
  EXPECT_EQ(CauseText(Cause::kOutOfRange), "out_of_range");
  EXPECT_EQ(CauseText(Cause::kDropped), "dropped");
  EXPECT_EQ(KindText(Kind::kAck), "ack");
}

TEST(Causes, StateWhatReachesTheDestination) {
  EXPECT_TRUE(IsReceived(Cause::kDelivered));
  EXPECT_TRUE(IsReceived(Cause::kDamaged));
  EXPECT_FALSE(IsReceived(Cause::kInTransit));
  EXPECT_FALSE(IsReceived(Cause::kRejected));
}

}  // namespace shoal::cause_test
