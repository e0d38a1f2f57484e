#include "lib/run/hosts/link_message.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sodium.h>

namespace shoal::link_message_test {

LinkMessage Example() {
  LinkMessage message{.kind = LinkKind::kTick, .mission_id = 7, .step = 12};
  message.AddText("NAV_ALPHA", "abc");
  message.AddText("TICK", "");
  return message;
}

/// Replaces the digest at the end, as a forger would.
void SealAnew(Bytes* bytes) {
  const size_t size = bytes->size() - 32;
  crypto_generichash(bytes->data() + size, 32, bytes->data(), size, nullptr, 0);
}

std::string ErrorOf(LinkIntake* intake, const Bytes& bytes) {
  const Result<LinkMessage> taken = intake->Take(bytes);
  return taken.ok() ? "" : taken.error();
}

TEST(LinkMessage, ArrivesAsItWasSent) {
  LinkIntake intake;
  const Result<LinkMessage> taken = intake.Take(EncodeLinkMessage(Example(), 0));
  ASSERT_TRUE(taken.ok()) << taken.error();
  EXPECT_EQ(*taken, Example());
  EXPECT_EQ(taken->TextOf("NAV_ALPHA"), "abc");
  EXPECT_EQ(taken->Find("NAV_BRAVO"), nullptr);
}

RC_GTEST_PROP(LinkMessage, WithOneBitTurnedIsRefused, ()) {
  Bytes bytes = EncodeLinkMessage(Example(), 0);
  const size_t at = *rc::gen::inRange<size_t>(0, bytes.size());
  bytes[at] = static_cast<uint8_t>(bytes[at] ^ 1 << *rc::gen::inRange(0, 8));
  LinkIntake intake;
  RC_ASSERT(!intake.Take(bytes).ok());
  RC_ASSERT(intake.num_refused() == 1);
}

RC_GTEST_PROP(LinkMessage, CutOffAnywhereIsRefused, ()) {
  Bytes bytes = EncodeLinkMessage(Example(), 0);
  bytes.resize(*rc::gen::inRange<size_t>(0, bytes.size()));
  LinkIntake intake;
  RC_ASSERT(!intake.Take(bytes).ok());
}

RC_GTEST_PROP(LinkMessage, WithAGoodDigestOverOtherBytesNeverReadsBeyondThem, ()) {
  // Past the magic; what comes out must be refused or re-encode to the same bytes.
  Bytes bytes = EncodeLinkMessage(Example(), 0);
  for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
    const size_t at = *rc::gen::inRange<size_t>(4, bytes.size() - 32);
    bytes[at] = *rc::gen::arbitrary<uint8_t>();
  }
  SealAnew(&bytes);
  LinkIntake intake;
  const Result<LinkMessage> taken = intake.Take(bytes);
  if (taken.ok()) RC_ASSERT(EncodeLinkMessage(*taken, 0) == bytes);
}

TEST(LinkMessage, IsTakenOnce) {
  LinkIntake intake;
  const Bytes first = EncodeLinkMessage(Example(), 0);
  ASSERT_TRUE(intake.Take(first).ok());
  EXPECT_EQ(ErrorOf(&intake, first), "a replayed batch: number 0, where 1 is next");
  EXPECT_TRUE(intake.Take(EncodeLinkMessage(Example(), 1)).ok());
  EXPECT_FALSE(intake.has_gap());
  EXPECT_EQ(ErrorOf(&intake, EncodeLinkMessage(Example(), 3)),
            "batch number 3, where 2 is next: one was lost");
  EXPECT_EQ(intake.num_refused(), 2);
  EXPECT_TRUE(intake.has_gap());
}

TEST(LinkMessage, OfAnotherMissionIsRefused) {
  LinkIntake intake;
  intake.set_mission_id(8);
  EXPECT_EQ(ErrorOf(&intake, EncodeLinkMessage(Example(), 0)),
            "a batch of another mission (7, where 8 runs)");
}

TEST(LinkMessage, WithAnotherCountThanItHoldsIsRefused) {
  Bytes bytes = EncodeLinkMessage(Example(), 0);
  constexpr size_t kCountEnd = 4 + 1 + 8 + 8 + 8 + 4;
  bytes[kCountEnd - 1] = 1;
  SealAnew(&bytes);
  LinkIntake intake;
  EXPECT_EQ(ErrorOf(&intake, bytes), "a batch that states 1 messages and holds others");
}

TEST(LinkMessage, ThatIsTooLargeIsRefused) {
  LinkIntake intake;
  EXPECT_EQ(ErrorOf(&intake, Bytes(kLargestLinkMessage_bytes + 1)),
            "a batch of 67108865 bytes; the largest has 67108864");
}

/// The largest message of a kind that has `parts` empty parts, or one part of `bytes`.
LinkMessage WithParts(LinkKind kind, size_t parts, size_t bytes = 0) {
  LinkMessage message{.kind = kind};
  for (size_t i = 0; i < parts; ++i) message.parts.push_back({.name = "", .data = Bytes(bytes)});
  return message;
}

TEST(LinkMessage, HasFewPartsAndBytesWhereItsKindNeedsNoMore) {
  for (const auto& [kind, most] : std::vector<std::pair<LinkKind, size_t>>{{LinkKind::kAlive, 0},
                                                                           {LinkKind::kAside, 1},
                                                                           {LinkKind::kPing, 1},
                                                                           {LinkKind::kSignal, 2},
                                                                           {LinkKind::kExit, 32}}) {
    LinkIntake intake;
    EXPECT_EQ(ErrorOf(&intake, EncodeLinkMessage(WithParts(kind, most), 0)), "");
    EXPECT_EQ(ErrorOf(&intake, EncodeLinkMessage(WithParts(kind, most + 1), 1)),
              "a batch of kind " + std::to_string(static_cast<int>(kind)) + " with " +
                  std::to_string(most + 1) + " messages; the most are " + std::to_string(most));
  }
  LinkIntake intake;
  EXPECT_EQ(ErrorOf(&intake, EncodeLinkMessage(WithParts(LinkKind::kAside, 1, 4 << 20), 0)),
            "a batch of kind 6 with 4194375 bytes; the largest has 4194304");
  EXPECT_EQ(ErrorOf(&intake, EncodeLinkMessage(WithParts(LinkKind::kTick, 3, 4 << 20), 0)), "");
}

TEST(LinkMessage, IsNotLookedAtWhereOneBeforeItWasLost) {
  LinkIntake intake;
  EXPECT_FALSE(intake.Take(EncodeLinkMessage(Example(), 1)).ok());
  EXPECT_EQ(ErrorOf(&intake, Bytes(3)), "a batch that follows a lost one");
  EXPECT_EQ(ErrorOf(&intake, EncodeLinkMessage(Example(), 0)), "a batch that follows a lost one");
}

}  // namespace shoal::link_message_test
