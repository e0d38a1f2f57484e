#include "lib/comms/swarm/schedule.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <climits>
#include <vector>

namespace shoal::schedule_test {

constexpr int64_t kTick_us = 100'000;
constexpr SwarmPlace kLeader = {.is_leader = true};

SlotPlan Fdma() {
  return {.scheme = SwarmScheme::kFdmaLf, .episode_us = 5'000'000, .offset_us = 500'000};
}

SlotPlan TdmaLf() {
  return {.scheme = SwarmScheme::kTdmaLf,
          .episode_us = 13'000'000,
          .offset_us = 0,
          .broadcast_us = 3'000'000,
          .response_us = 1'000'000,
          .answer_window_us = 500'000};
}

struct SentMessage {
  int64_t utime = 0;
  DueMessage due;
};

/// Returns what is sent in all steps from `from_us` to `to_us`.
std::vector<SentMessage> SentBy(SwarmSchedule* schedule, int64_t from_us, int64_t to_us,
                                int64_t tick_us = kTick_us) {
  std::vector<SentMessage> sent;
  for (int64_t utime = from_us; utime <= to_us; utime += tick_us) {
    if (const auto due = schedule->Due(utime)) sent.push_back({utime, *due});
  }
  return sent;
}

std::vector<int64_t> TimesOf(const std::vector<SentMessage>& sent) {
  std::vector<int64_t> utimes;
  for (const SentMessage& one : sent) utimes.push_back(one.utime);
  return utimes;
}

TEST(FdmaSchedule, BeginsAtItsPlaceAndComesAgainEveryEpisode) {
  SwarmSchedule schedule(Fdma(), {.place = 3});
  const std::vector<SentMessage> sent = SentBy(&schedule, 0, 12'000'000);
  EXPECT_EQ(TimesOf(sent), (std::vector<int64_t>{1'500'000, 6'500'000, 11'500'000}));
  EXPECT_EQ(sent.at(1).due, (DueMessage{.message = SwarmMessage::kReport, .slot_us = 6'500'000}));
}

TEST(FdmaSchedule, LetsTheLeaderSendLeaderReports) {
  SwarmSchedule schedule(Fdma(), {.is_leader = true, .place = 0});
  const auto due = schedule.Due(0);
  ASSERT_TRUE(due);
  EXPECT_EQ(due->message, SwarmMessage::kLeaderReport);
}

TEST(FdmaSchedule, MayHaveItsFirstSlotAfterAnEpisode) {
  SwarmSchedule schedule(Fdma(), {.place = 11});
  EXPECT_EQ(TimesOf(SentBy(&schedule, 0, 12'000'000)),
            (std::vector<int64_t>{5'500'000, 10'500'000}));
}

TEST(TdmaSchedule, GivesEachMemberASlotOfEveryFrame) {
  const SlotPlan plan = {
      .scheme = SwarmScheme::kTdma, .episode_us = 3'600'000, .offset_us = 1'200'000};
  SwarmSchedule last(plan, {.place = 2});
  SwarmSchedule leader(plan, kLeader);
  EXPECT_EQ(TimesOf(SentBy(&last, 0, 7'000'000)), (std::vector<int64_t>{2'400'000, 6'000'000}));
  const std::vector<SentMessage> sent = SentBy(&leader, 0, 7'000'000);
  EXPECT_EQ(TimesOf(sent), (std::vector<int64_t>{0, 3'600'000}));
  EXPECT_EQ(sent.at(0).due.message, SwarmMessage::kLeaderReport);
}

TEST(TdmaLfSchedule, LetsTheLeaderAskAtTheBeginningOfEachEpisode) {
  SwarmSchedule schedule(TdmaLf(), kLeader);
  const std::vector<SentMessage> sent = SentBy(&schedule, 0, 26'000'000);
  EXPECT_EQ(TimesOf(sent), (std::vector<int64_t>{0, 13'000'000, 26'000'000}));
  EXPECT_EQ(sent.at(1).due, (DueMessage{.message = SwarmMessage::kBroadcastRequest,
                                        .slot_us = 13'000'000,
                                        .response_start_us = 16'000'000}));
}

TEST(TdmaLfSchedule, LetsAFollowerSendNothingUntilItIsAsked) {
  SwarmSchedule schedule(TdmaLf(), {});
  EXPECT_TRUE(SentBy(&schedule, 0, 30'000'000).empty());
}

TEST(TdmaLfSchedule, LetsAFollowerAnswerEachRequestOnceInItsSlot) {
  SwarmSchedule schedule(TdmaLf(), {});
  schedule.Take({3'000'000, 4});
  const std::vector<SentMessage> sent = SentBy(&schedule, 2'900'000, 30'000'000);
  EXPECT_EQ(TimesOf(sent), std::vector<int64_t>{7'000'000});
  EXPECT_EQ(sent.at(0).due, (DueMessage{.message = SwarmMessage::kResponse, .slot_us = 7'000'000}));
  schedule.Take({3'000'000, 4});
  EXPECT_TRUE(SentBy(&schedule, 7'100'000, 30'000'000).empty()) << "the same request again";
  EXPECT_EQ(schedule.num_missed(), 0);
}

TEST(TdmaLfSchedule, AnswersALateRequestOnlyWhileTheAnswerFitsIntoTheSlot) {
  SwarmSchedule schedule(TdmaLf(), {});
  schedule.Take({3'000'000, 0});
  EXPECT_EQ(TimesOf(SentBy(&schedule, 3'400'000, 4'000'000)), std::vector<int64_t>{3'400'000});
  schedule.Take({16'000'000, 0});
  EXPECT_TRUE(SentBy(&schedule, 16'500'000, 18'000'000).empty());
  EXPECT_EQ(schedule.num_missed(), 1);
}

TEST(TdmaLfSchedule, AnswersAStepLateWhateverTheWindow) {
  SlotPlan plan = TdmaLf();
  plan.answer_window_us = 0;
  plan.response_us = 950'000;  // Slot 1 begins between two steps.
  SwarmSchedule schedule(plan, {});
  schedule.Take({3'000'000, 1});
  EXPECT_EQ(TimesOf(SentBy(&schedule, 3'000'000, 5'000'000)), std::vector<int64_t>{4'000'000});
}

TEST(TdmaLfSchedule, ReplacesARequestByTheNext) {
  SwarmSchedule schedule(TdmaLf(), {});
  schedule.Take({3'000'000, 9});
  schedule.Take({16'000'000, 0});
  EXPECT_EQ(TimesOf(SentBy(&schedule, 3'000'000, 30'000'000)), std::vector<int64_t>{16'000'000});
  EXPECT_EQ(schedule.num_missed(), 1);
}

TEST(TdmaLfSchedule, FindsTheStepThatAFloatOnTheAirMeant) {
  for (const int64_t step : {181, 100'003, 1'000'001}) {
    SwarmSchedule schedule(TdmaLf(), {});
    const auto start_s = static_cast<float>(static_cast<double>(step) * 0.1);
    schedule.Take({static_cast<int64_t>(static_cast<double>(start_s) * 1e6), 2});
    const int64_t slot_us = step * kTick_us + 2'000'000;
    EXPECT_EQ(TimesOf(SentBy(&schedule, slot_us - 500'000, slot_us + 500'000)),
              std::vector<int64_t>{slot_us});
  }
}

TEST(TdmaLfSchedule, IsNotHarmedByImpossibleRequests) {
  SwarmSchedule schedule(TdmaLf(), {});
  for (const int64_t start_us : {INT64_MIN, int64_t{-1}, INT64_MAX}) {
    for (const int slot : {INT_MIN, 0, INT_MAX}) schedule.Take({start_us, slot});
  }
  schedule.Take({0, -1});
  schedule.Take({0, INT_MAX});
  EXPECT_TRUE(SentBy(&schedule, 0, 30'000'000).empty());
  SwarmSchedule leader(TdmaLf(), kLeader);
  leader.Take({3'000'000, 0});
  EXPECT_EQ(TimesOf(SentBy(&leader, 0, 14'000'000)), (std::vector<int64_t>{0, 13'000'000}));
}

TEST(SwarmSchedule, TakesASlotInTheFirstStepThatIsNotBeforeIt) {
  SlotPlan plan = Fdma();
  plan.episode_us = 4'250'000;
  SwarmSchedule schedule(plan, kLeader);
  const std::vector<SentMessage> sent = SentBy(&schedule, 0, 13'000'000);
  EXPECT_EQ(TimesOf(sent), (std::vector<int64_t>{0, 4'300'000, 8'500'000, 12'800'000}));
  EXPECT_EQ(sent.at(1).due.slot_us, 4'250'000);
}

TEST(SwarmSchedule, SendsNothingTwiceInAStep) {
  SwarmSchedule schedule(Fdma(), kLeader);
  EXPECT_TRUE(schedule.Due(5'000'000));
  EXPECT_FALSE(schedule.Due(5'000'000));
  EXPECT_FALSE(schedule.Due(5'050'000));
  EXPECT_FALSE(schedule.Due(0));
}

TEST(SwarmSchedule, IsBackAtTheNextSlotAfterAGapWithoutABurst) {
  SwarmSchedule schedule(Fdma(), {.place = 1});
  EXPECT_TRUE(schedule.Due(500'000));
  EXPECT_EQ(TimesOf(SentBy(&schedule, 23'000'000, 27'000'000)), std::vector<int64_t>{25'500'000});
}

TEST(SwarmSchedule, NeedsNoTimeOfAnyMissionToBeSafe) {
  SwarmSchedule schedule(Fdma(), kLeader);
  for (const int64_t utime : {INT64_MIN, int64_t{-1}}) EXPECT_FALSE(schedule.Due(utime));
  (void)schedule.Due(INT64_MAX);
  EXPECT_FALSE(schedule.Due(INT64_MAX));
  EXPECT_FALSE(schedule.Due(INT64_MIN));
}

TEST(SwarmSchedule, IsExactAfterAMillionEpisodes) {
  constexpr int64_t kEpisode_us = 4'200'000;  // On its floats muNet loses 134 of 143 such.
  SlotPlan plan = TdmaLf();
  plan.tick_us = 20'000;
  plan.episode_us = kEpisode_us;
  SwarmSchedule leader(plan, kLeader);
  SwarmSchedule follower(plan, {});
  for (int64_t episode = 0; episode < 1'000'000; ++episode) {
    const int64_t begin_us = episode * kEpisode_us;
    ASSERT_FALSE(leader.Due(begin_us - plan.tick_us)) << episode;
    const auto due = leader.Due(begin_us);
    ASSERT_TRUE(due) << episode;
    ASSERT_EQ(due->slot_us, begin_us);
    follower.Take({due->response_start_us, 1});
    ASSERT_FALSE(follower.Due(begin_us + 3'980'000)) << episode;
    ASSERT_TRUE(follower.Due(begin_us + 4'000'000)) << episode;
  }
}

RC_GTEST_PROP(SwarmSchedule, GoesOnAfterARestartAsIfThereHadBeenNone, ()) {
  SlotPlan plan = Fdma();
  plan.tick_us = *rc::gen::element<int64_t>(20'000, 30'000, 100'000);
  plan.episode_us = *rc::gen::inRange<int64_t>(plan.tick_us, 3'000'000);
  plan.offset_us = *rc::gen::inRange<int64_t>(0, 1'000'000);
  const SwarmPlace place = {.place = *rc::gen::inRange<int64_t>(0, 12)};
  const int64_t restart_us = *rc::gen::inRange<int64_t>(0, 500) * plan.tick_us;
  SwarmSchedule old(plan, place);
  SwarmSchedule restarted(plan, place);
  (void)SentBy(&old, 0, restart_us - plan.tick_us, plan.tick_us);
  const int64_t end_us = restart_us + 10'000'000;
  RC_ASSERT(TimesOf(SentBy(&restarted, restart_us, end_us, plan.tick_us)) ==
            TimesOf(SentBy(&old, restart_us, end_us, plan.tick_us)));
}

RC_GTEST_PROP(SwarmSchedule, BeginsAtItsPlaceAndLeavesNoSlotOut, ()) {
  SlotPlan plan = Fdma();
  plan.episode_us = *rc::gen::inRange<int64_t>(kTick_us, 3'000'000);
  plan.offset_us = *rc::gen::inRange<int64_t>(0, 1'000'000);
  const auto place = *rc::gen::inRange<int64_t>(0, 12);
  SwarmSchedule schedule(plan, {.place = place});
  int64_t next_us = place * plan.offset_us;
  for (int64_t utime = 0; utime < 20'000'000; utime += kTick_us) {
    const auto due = schedule.Due(utime);
    RC_ASSERT(due.has_value() == (next_us <= utime));
    if (!due) continue;
    RC_ASSERT(due->slot_us == next_us);
    next_us += plan.episode_us;
  }
}

}  // namespace shoal::schedule_test
