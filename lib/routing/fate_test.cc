#include "lib/routing/fate.h"

#include <gtest/gtest.h>

#include <set>

namespace shoal {
namespace {

TEST(FateTexts, AreDifferentAndLikeOnesInMissionFiles) {
  std::set<std::string_view> texts;
  for (int i = 0; i < kNumCauses; ++i) texts.insert(CauseText(static_cast<Cause>(i)));
  for (int i = 0; i < kNumKinds; ++i) texts.insert(KindText(static_cast<Kind>(i)));
  texts.insert(OverrideText(OverrideRule::kCriticalRange));
  texts.insert(OverrideText(OverrideRule::kFullReport));
  EXPECT_EQ(texts.size(), static_cast<size_t>(kNumCauses + kNumKinds + 2));
  for (const std::string_view text : texts) {
    EXPECT_FALSE(text.empty());
    EXPECT_EQ(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), text.npos) << text;
  }
  EXPECT_EQ(OverrideText(OverrideRule::kNone), "");
}

TEST(Causes, BelongToTheKindsWhoseRulesAskForThem) {
  const auto count = [](Kind kind) {
    int num = 0;
    for (int i = 0; i < kNumCauses; ++i) num += CanHave(kind, static_cast<Cause>(i)) ? 1 : 0;
    return num;
  };
  EXPECT_EQ(count(Kind::kReport), 19);
  EXPECT_EQ(count(Kind::kMessage), 22);
  EXPECT_EQ(count(Kind::kAck), 19);
  EXPECT_EQ(count(Kind::kPacket), 14);
  EXPECT_FALSE(CanHave(Kind::kReport, Cause::kUnknownSource));
  EXPECT_FALSE(CanHave(Kind::kPacket, Cause::kStaleReceiver));
  EXPECT_FALSE(CanHave(Kind::kMessage, Cause::kIgnoredGroup));
  EXPECT_FALSE(CanHave(Kind::kAck, Cause::kTooSoon));
}

TEST(FateTexts, StandAtTheirCauses) {
  EXPECT_EQ(CauseText(Cause::kDelivered), "delivered");
  EXPECT_EQ(CauseText(Cause::kTooSoon), "too_soon");
  EXPECT_EQ(CauseText(Cause::kUnknownDestination), "unknown_destination");
  EXPECT_EQ(CauseText(Cause::kOutOfRange), "out_of_range");
  EXPECT_EQ(CauseText(Cause::kDropped), "dropped");
  EXPECT_EQ(static_cast<int>(Cause::kDropped), kNumRuleCauses - 1);
  EXPECT_EQ(KindText(Kind::kAck), "ack");
}

}  // namespace
}  // namespace shoal
