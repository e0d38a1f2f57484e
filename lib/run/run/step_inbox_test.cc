#include "lib/run/run/step_inbox.h"

#include <gtest/gtest.h>

namespace shoal::step_inbox_test {

constexpr int64_t kMissionId = 99;

Bytes Sealed(const std::string& publisher, int64_t step, uint32_t sequence, uint8_t content,
             int64_t mission_id = kMissionId, std::string_view channel = "Y") {
  Bytes bytes = {content};
  AppendSeal({.publisher = publisher, .mission_id = mission_id, .step = step, .sequence = sequence},
             MissionSecret{}, channel, &bytes);
  return bytes;
}

tick_t TickAfter(int64_t step, std::vector<step_total_t> totals) {
  tick_t tick{};
  tick.step = step + 1;
  tick.mission_id = kMissionId;
  tick.totals = std::move(totals);
  tick.num_totals = static_cast<int32_t>(tick.totals.size());
  return tick;
}

StepInbox WantsAll() {
  return StepInbox([](std::string_view) { return true; }, MissionSecret{});
}

std::string Contents(const std::vector<StepInbox::Stored>& messages) {
  std::string out;
  for (const auto& message : messages) {
    out +=
        message.channel + "/" + message.publisher + "/" + static_cast<char>(message.data[0]) + " ";
  }
  return out;
}

TEST(StepInbox, OrdersByChannelThenPublisherThenSequence) {
  StepInbox inbox = WantsAll();
  inbox.Add("Y", Sealed("b", 0, 1, '1'), kMissionId);
  inbox.Add("X", Sealed("b", 0, 0, '2', kMissionId, "X"), kMissionId);
  inbox.Add("Y", Sealed("a", 0, 7, '3'), kMissionId);
  inbox.Add("Y", Sealed("a", 0, 3, '4'), kMissionId);
  inbox.Add("Y", Bytes{'5'}, kMissionId);
  const tick_t tick = TickAfter(0, {{"a", "Y", 2}, {"b", "X", 1}, {"b", "Y", 1}});
  EXPECT_TRUE(inbox.Missing(tick).empty());
  EXPECT_EQ(Contents(inbox.Take(tick)), "X/b/2 Y//5 Y/a/4 Y/a/3 Y/b/1 ");
  EXPECT_EQ(inbox.counters().outside, 1);
}

TEST(StepInbox, KnowsWhatIsMissingOfWhatItSubscribedTo) {
  StepInbox inbox([](std::string_view channel) { return channel == "Y"; }, MissionSecret{});
  inbox.Add("Y", Sealed("a", 0, 0, '1'), kMissionId);
  const tick_t tick = TickAfter(0, {{"a", "Y", 3}, {"a", "NOT_MINE", 5}});
  const auto missing = inbox.Missing(tick);
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing[0].channel, "Y");
  EXPECT_EQ(missing[0].received, 1);
  EXPECT_EQ(missing[0].expected, 3);
}

TEST(StepInbox, TakesARepeatedDatagramOnce) {
  StepInbox inbox = WantsAll();
  inbox.Add("Y", Sealed("a", 0, 0, '1'), kMissionId);
  inbox.Add("Y", Sealed("a", 0, 0, '1'), kMissionId);
  EXPECT_EQ(Contents(inbox.Take(TickAfter(0, {{"a", "Y", 1}}))), "Y/a/1 ");
  EXPECT_EQ(inbox.counters().late, 1);
}

TEST(StepInbox, RejectsMessagesOfAnotherMission) {
  StepInbox inbox = WantsAll();
  inbox.Add("Y", Sealed("a", 0, 0, '1', 12345), kMissionId);
  EXPECT_TRUE(inbox.Take(TickAfter(0, {})).empty());
  EXPECT_EQ(inbox.counters().foreign, 1);
}

TEST(StepInbox, KeepsWhatAFasterPublisherPublishedForTheNextStep) {
  StepInbox inbox = WantsAll();
  inbox.Add("Y", Sealed("a", 0, 0, '1'), kMissionId);
  inbox.Add("Y", Sealed("a", 1, 0, '2'), kMissionId);
  EXPECT_EQ(Contents(inbox.Take(TickAfter(0, {{"a", "Y", 1}}))), "Y/a/1 ");
  EXPECT_EQ(Contents(inbox.Take(TickAfter(1, {{"a", "Y", 1}}))), "Y/a/2 ");
}

TEST(StepInbox, IgnoresWhatNoTotalAnnounced) {
  // Its publisher died before the step was done: some received it, some did not.
  StepInbox inbox = WantsAll();
  inbox.Add("Y", Sealed("dead", 0, 0, '1'), kMissionId);
  EXPECT_TRUE(inbox.Take(TickAfter(0, {})).empty());
}

TEST(StepInbox, DropsWhatComesAfterItsStep) {
  StepInbox inbox = WantsAll();
  EXPECT_TRUE(inbox.Take(TickAfter(0, {})).empty());
  inbox.Add("Y", Sealed("a", 0, 0, '1'), kMissionId);
  EXPECT_TRUE(inbox.Take(TickAfter(1, {{"a", "Y", 1}})).empty());
  EXPECT_EQ(inbox.counters().late, 1);
}

TEST(StepInbox, HoldsNoMoreFromOutsideThanAStepMayBring) {
  StepInbox inbox = WantsAll();
  for (size_t i = 0; i < StepInbox::kMaxOutside + 7; ++i) inbox.Add("Y", Bytes{'1'}, kMissionId);
  EXPECT_EQ(inbox.counters().dropped, 7);
  EXPECT_EQ(inbox.Take(TickAfter(0, {})).size(), StepInbox::kMaxOutside);
  inbox.Add("Y", Bytes{'1'}, kMissionId);
  EXPECT_EQ(inbox.counters().dropped, 7) << "the next step has room again";
}

TEST(StepInbox, StoresNothingForStepsFarAhead) {
  StepInbox inbox = WantsAll();
  EXPECT_TRUE(inbox.Take(TickAfter(0, {})).empty());
  inbox.Add("Y", Sealed("a", 1'000'000, 0, '1'), kMissionId);
  EXPECT_EQ(inbox.counters().late, 1);
}

TEST(StepInbox, RefusesWhatAnotherProcessSealed) {
  StepInbox inbox = WantsAll();
  Bytes copied = Sealed("a", 0, 0, '1');
  Bytes renumbered = copied;
  renumbered[renumbered.size() - 21] ^= 1;  // The last byte of the sequence number.
  inbox.Add("Y", renumbered, kMissionId);
  inbox.Add("X", copied, kMissionId);  // On another channel.
  EXPECT_EQ(inbox.counters().forged, 2);
  EXPECT_EQ(inbox.first_forged(), "Y in the name of a");
  inbox.Add("Y", copied, kMissionId);
  EXPECT_EQ(Contents(inbox.Take(TickAfter(0, {{"a", "Y", 1}}))), "Y/a/1 ");
}

TEST(StepInbox, NamesAPublisherOfMoreThanItAnnounced) {
  StepInbox inbox = WantsAll();
  for (uint32_t i = 0; i < 3; ++i) inbox.Add("Y", Sealed("a", 0, i, '1'), kMissionId);
  EXPECT_TRUE(inbox.Excess(TickAfter(0, {{"a", "Y", 3}})).empty());
  EXPECT_TRUE(inbox.Excess(TickAfter(0, {{"b", "Y", 3}})).empty()) << "a was lost";
  const auto excess = inbox.Excess(TickAfter(0, {{"a", "Y", 2}}));
  ASSERT_EQ(excess.size(), 1U);
  EXPECT_EQ(excess[0].publisher, "a");
  EXPECT_EQ(excess[0].received, 3);
  EXPECT_EQ(excess[0].expected, 2);
}

TEST(StepInbox, KeepsThreeStepsAtMostBeforeTheFirstTick) {
  StepInbox inbox = WantsAll();
  for (int64_t step = 0; step < 1000; ++step) {
    EXPECT_EQ(inbox.Add("Y", Sealed("a", step, 0, '1'), kMissionId), step);
  }
  EXPECT_EQ(inbox.num_sealed(), static_cast<size_t>(StepInbox::kMaxSteps));
  inbox.Add("Y", Sealed("a", 10, 0, '1'), kMissionId);
  EXPECT_EQ(inbox.counters().late, 1);
  inbox.StartAt(998);
  EXPECT_EQ(Contents(inbox.Take(TickAfter(998, {{"a", "Y", 1}}))), "Y/a/1 ");
}

TEST(StepInbox, HoldsNoMoreBytesThanItsLimit) {
  StepInbox inbox = WantsAll();
  const size_t size = StepInbox::kMaxSealedBytes / 16;
  for (uint32_t i = 0; i < 20; ++i) {
    Bytes bytes(size, 1);
    AppendSeal({.publisher = "a", .mission_id = kMissionId, .step = 0, .sequence = i},
               MissionSecret{}, "Y", &bytes);
    inbox.Add("Y", bytes, kMissionId);
  }
  EXPECT_EQ(inbox.num_sealed(), 16U);
  EXPECT_EQ(inbox.counters().no_room, 4);
  inbox.StartAt(1);
  EXPECT_EQ(inbox.num_sealed(), 0U);
}

}  // namespace shoal::step_inbox_test
