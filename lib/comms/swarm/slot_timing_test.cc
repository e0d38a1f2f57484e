#include "lib/comms/swarm/slot_timing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace shoal::slot_timing_test {

constexpr int64_t kTick_us = 100'000;

std::vector<std::string> MessagesOf(const std::vector<TimingProblem>& problems) {
  std::vector<std::string> messages;
  for (const TimingProblem& problem : problems) messages.push_back(problem.message);
  return messages;
}

const std::vector<std::string> kNothing;

/// muNet's defaults.
SlotPlan MuNetPlan() {
  return {.scheme = SwarmScheme::kTdmaLf,
          .episode_us = 5'000'000,
          .broadcast_us = 1'000'000,
          .response_us = 1'000'000};
}

TEST(AirTimes, AreThoseOfTheBytesAndTheWay) {
  const SwarmAir air = {.num_followers = 9, .max_distance_m = 1500, .max_jitter_s = 0.2};
  EXPECT_EQ(*FindAirTimes(air), (AirTimes{.report_us = 296'000,
                                          .leader_report_us = 456'000,
                                          .request_us = 2'824'000,
                                          .travel_us = 1'000'000,
                                          .jitter_us = 200'000}));
}

TEST(AirTimes, CountChecksumAndFrame) {
  const SwarmAir air = {.num_followers = 1, .extra_bytes = 8};
  const AirTimes times = *FindAirTimes(air);
  EXPECT_EQ(times.report_us, 360'000);
  EXPECT_EQ(times.leader_report_us, 520'000);
  EXPECT_EQ(times.request_us, 840'000);
}

TEST(TimingProblems, ShowThatNineFollowersDoNotFitIntoMuNetsDefaults) {
  EXPECT_EQ(
      MessagesOf(FindTimingProblems(MuNetPlan(), {.num_followers = 9})),
      (std::vector<std::string>{
          "broadcast_s = 1 is too short for a request to 9 followers: 353 bytes at 1000 bit/s take "
          "2.824 s + 0.666667 s for 1000 m + 0.2 s of jitter, in whole steps, + 0.1 s to handle "
          "it = 3.8 s; use at least 3.8, or broadcast_s = \"auto\"",
          "response_s = 1 is too short for an answer: 37 bytes at 1000 bit/s take 0.296 s + "
          "0.666667 s for 1000 m + 0.2 s of jitter = 1.162667 s; use at least 1.2, or response_s = "
          "\"auto\"",
          "episode_s = 5 is too short for 9 followers: 3.8 s for the request + 9 x 1.2 s of "
          "answers = 14.6 s; use at least 14.6, or episode_s = \"auto\""}));
}

TEST(TimingProblems, ShowWhatDoesNotFitIntoFdmaAndTdma) {
  const SwarmAir air = {.num_followers = 1, .max_distance_m = 150, .max_jitter_s = 0};
  SlotPlan plan = {.scheme = SwarmScheme::kFdmaLf, .episode_us = 500'000, .offset_us = 50'000};
  EXPECT_EQ(MessagesOf(FindTimingProblems(plan, air)),
            (std::vector<std::string>{
                "offset_s = 0.05 is not a whole number of steps of 0.1 s; use 0.1, or offset_s = "
                "\"auto\"",
                "episode_s = 0.5 is too short for a leader's report: 57 bytes at 1000 bit/s take "
                "0.456 s + 0.1 s for 150 m + 0 s of jitter = 0.556 s; use at least 0.6, or "
                "episode_s = \"auto\""}));
  plan = {.scheme = SwarmScheme::kTdma, .episode_us = 1'000'000, .offset_us = 600'000};
  EXPECT_EQ(MessagesOf(FindTimingProblems(plan, air)),
            (std::vector<std::string>{"episode_s = 1 is too short for 2 members: 2 x 0.6 s of "
                                      "offset_s = 1.2 s; use at least 1.2, or episode_s = "
                                      "\"auto\""}));
}

TEST(TimingProblems, ShowThatLateAnswersWouldRunIntoTheNextSlot) {
  const SwarmAir air = {.num_followers = 2, .max_distance_m = 150, .max_jitter_s = 0};
  SlotPlan plan = {.scheme = SwarmScheme::kTdmaLf,
                   .episode_us = 5'000'000,
                   .broadcast_us = 2'000'000,
                   .response_us = 1'000'000,
                   .answer_window_us = 604'001};
  EXPECT_EQ(MessagesOf(FindTimingProblems(plan, air)), kNothing);
  ++plan.answer_window_us;
  EXPECT_EQ(MessagesOf(FindTimingProblems(plan, air)),
            std::vector<std::string>{"answer_window_s = 0.604002 lets late answers run into the "
                                     "next slot; use at most 0.604001"});
}

TEST(TimingProblems, ListNumbersThatAreOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  SwarmAir air = {.num_followers = 0,
                  .extra_bytes = -1,
                  .data_rate_bps = 0,
                  .sound_speed_mps = nan,
                  .max_distance_m = infinity,
                  .max_jitter_s = -1};
  SlotPlan plan = {.tick_us = 0, .episode_us = INT64_MAX, .offset_us = INT64_MIN};
  EXPECT_EQ(
      MessagesOf(FindTimingProblems(plan, air)),
      (std::vector<std::string>{
          "num_followers must be 1 to 1000, not 0", "extra_bytes must be 0 to 1000, not -1",
          "data_rate_bps must be more than 0, not 0",
          "sound_speed_mps must be more than 0, not nan",
          "max_distance_m must be 0 or more, not inf", "max_jitter_s must be 0 or more, not -1",
          "tick_s must be more than 0, at most 3600, not 0",
          "episode_s must be at most 900000, not 9223372036854.775807",
          "offset_s must be at most 900000, not -9223372036854.775808"}));
  EXPECT_FALSE(FindAirTimes(air).ok());
  EXPECT_FALSE(AutoPlan(SwarmScheme::kTdma, kTick_us, air).ok());
  EXPECT_FALSE(AutoPlan(SwarmScheme::kTdma, 0, {}).ok());
}

TEST(TimingProblems, ShowMessagesThatTakeTooLong) {
  const SwarmAir air = {.num_followers = 1000, .data_rate_bps = 1e-300};
  ASSERT_EQ(FindTimingProblems(MuNetPlan(), air).size(), 1U);
  EXPECT_FALSE(AutoPlan(SwarmScheme::kTdmaLf, kTick_us, air).ok());
  const SwarmAir vast = {.num_followers = 1000, .max_distance_m = 3e6};
  EXPECT_FALSE(AutoPlan(SwarmScheme::kTdmaLf, kTick_us, vast).ok());
}

TEST(AutoPlan, AddsUpToWholeSteps) {
  const SlotPlan plan = *AutoPlan(SwarmScheme::kTdmaLf, kTick_us, {.num_followers = 9});
  EXPECT_EQ(plan, (SlotPlan{.scheme = SwarmScheme::kTdmaLf,
                            .episode_us = 14'600'000,
                            .offset_us = 0,
                            .broadcast_us = 3'800'000,
                            .response_us = 1'200'000,
                            .answer_window_us = 37'334}));
}

TEST(AutoPlan, SpreadsFdmaOverTheShortestEpisode) {
  const SlotPlan plan = *AutoPlan(SwarmScheme::kFdmaLf, kTick_us, {.num_followers = 4});
  EXPECT_EQ(plan.episode_us, 1'400'000);
  EXPECT_EQ(plan.offset_us, 200'000);
}

TEST(AutoPlan, AddsNoStepForTheNoiseOfDoubles) {
  // 8 * 57 / 760 s are 0.6 s, but not in doubles.
  const SwarmAir air = {
      .num_followers = 2, .data_rate_bps = 760, .max_distance_m = 0, .max_jitter_s = 0};
  EXPECT_EQ(AutoPlan(SwarmScheme::kTdma, kTick_us, air)->offset_us, 600'000);
}

SwarmAir AnyAir() {
  return {.num_followers = *rc::gen::inRange<int64_t>(1, 40),
          .extra_bytes = *rc::gen::inRange<int64_t>(0, 12),
          .data_rate_bps = *rc::gen::inRange(50, 20'000) * 1.01,
          .sound_speed_mps = *rc::gen::inRange(1400, 1600) * 1.003,
          .max_distance_m = *rc::gen::inRange(0, 8000) * 1.007,
          .max_jitter_s = *rc::gen::inRange(0, 1000) * 1e-3};
}

SwarmScheme AnyScheme() {
  return *rc::gen::element(SwarmScheme::kFdmaLf, SwarmScheme::kTdma, SwarmScheme::kTdmaLf);
}

RC_GTEST_PROP(AutoPlan, HasNoProblemsAndNothingToSpare, ()) {
  const SwarmAir air = AnyAir();
  const int64_t tick_us = *rc::gen::element<int64_t>(20'000, 30'000, 100'000, 1'000'000);
  const SlotPlan plan = *AutoPlan(AnyScheme(), tick_us, air);
  RC_ASSERT(MessagesOf(FindTimingProblems(plan, air)) == kNothing);
  for (int64_t SlotPlan::*length :
       {&SlotPlan::episode_us, &SlotPlan::broadcast_us, &SlotPlan::response_us}) {
    if (plan.*length == 0) continue;
    SlotPlan shorter = plan;
    shorter.*length -= tick_us;
    if (length == &SlotPlan::response_us) shorter.answer_window_us = 0;
    RC_ASSERT(!FindTimingProblems(shorter, air).empty());
  }
}

RC_GTEST_PROP(TimingProblems, AreFixedByAllRemediesTogether, ()) {
  const SwarmAir air = AnyAir();
  SlotPlan plan = {.scheme = AnyScheme(),
                   .episode_us = *rc::gen::inRange<int64_t>(-10, 20'000'000),
                   .offset_us = *rc::gen::inRange<int64_t>(-10, 2'000'000),
                   .broadcast_us = *rc::gen::inRange<int64_t>(-10, 4'000'000),
                   .response_us = *rc::gen::inRange<int64_t>(-10, 2'000'000)};
  for (const TimingProblem& problem : FindTimingProblems(plan, air)) {
    RC_ASSERT(problem.at_least_us > 0 && problem.at_least_us % plan.tick_us == 0);
    if (problem.key == "episode_s") plan.episode_us = problem.at_least_us;
    if (problem.key == "offset_s") plan.offset_us = problem.at_least_us;
    if (problem.key == "broadcast_s") plan.broadcast_us = problem.at_least_us;
    if (problem.key == "response_s") plan.response_us = problem.at_least_us;
  }
  RC_ASSERT(MessagesOf(FindTimingProblems(plan, air)) == kNothing);
}

}  // namespace shoal::slot_timing_test
