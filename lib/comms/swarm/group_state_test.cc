#include "lib/comms/swarm/group_state.h"

#include <gtest/gtest.h>

namespace shoal::group_state_test {

constexpr int64_t kSecond_us = 1'000'000;

MotionLog LogOf(int64_t num_entries) {
  MotionLog log;
  for (int64_t i = 0; i < num_entries; ++i) {
    AppendToLog({.time_us = i, .motion = {.position_m = {static_cast<double>(i), 0, 0}}}, &log);
  }
  return log;
}

SwarmContact ContactReportedAt(double time_s) {
  SwarmContact contact =
      PlacedContact(2, 'A', {.position_m = {10, 20, 5}, .velocity_mps = {2, -1, 0.5}});
  contact.has_reported = true;
  contact.reported_us = static_cast<int64_t>(time_s * 1e6);
  return contact;
}

TEST(MotionLog, DoublesWhenItIsFull) {
  EXPECT_EQ(LogOf(0).capacity, 512U);
  EXPECT_EQ(LogOf(512).capacity, 512U);
  EXPECT_EQ(LogOf(513).capacity, 1024U);
  EXPECT_EQ(LogOf(1025).capacity, 2048U);
}

TEST(MotionLog, KeepsEverythingInOrderWhileItGrows) {
  const MotionLog log = LogOf(2000);
  ASSERT_EQ(log.entries.size(), 2000U);
  for (size_t i = 0; i < 2000; ++i) ASSERT_EQ(log.entries[i].time_us, static_cast<int64_t>(i));
}

TEST(MotionLog, DropsTheOldestAtItsGreatestCapacity) {
  const auto max = static_cast<int64_t>(MotionLog::kMaxCapacity);
  const MotionLog log = LogOf(max + 10);
  EXPECT_EQ(log.capacity, MotionLog::kMaxCapacity);
  EXPECT_EQ(log.entries.size(), MotionLog::kMaxCapacity);
  EXPECT_EQ(log.entries.front().time_us, 10);
  EXPECT_EQ(log.entries.back().time_us, max + 9);
}

TEST(MotionLog, KeepsTheNewestWhenItIsMadeSmaller) {
  MotionLog log = LogOf(100);
  ResizeLog(3, &log);
  ASSERT_EQ(log.entries.size(), 3U);
  EXPECT_EQ(log.entries.front().time_us, 97);
  ResizeLog(600, &log);
  EXPECT_EQ(log.capacity, 600U);
  EXPECT_EQ(log.entries.size(), 3U);
}

TEST(MotionLog, HasOneEntryForATime) {
  MotionLog log = LogOf(3);
  AppendToLog({.time_us = 2, .motion = {.position_m = {77, 0, 0}}}, &log);
  EXPECT_EQ(log.entries.size(), 3U);
  EXPECT_EQ(log.entries.back().motion.position_m.x(), 77);
}

TEST(MotionLog, TakesNothingOlderThanItsNewest) {
  MotionLog log = LogOf(3);
  AppendToLog({.time_us = 1}, &log);
  EXPECT_EQ(log.entries.size(), 3U);
  EXPECT_EQ(log.entries[1].motion.position_m.x(), 1);
}

TEST(MotionLog, GivesItsLastEntries) {
  const MotionLog log = LogOf(5);
  const auto last = LastEntries(log, 2);
  ASSERT_EQ(last.size(), 2U);
  EXPECT_EQ(last[0].time_us, 3);
  EXPECT_EQ(last[1].time_us, 4);
  EXPECT_EQ(LastEntries(log, 9).size(), 5U);
}

TEST(Prediction, StartsAtTheTimeStampOfTheReport) {
  SwarmContact contact = ContactReportedAt(10);
  contact.arrived_us = 13 * kSecond_us;
  const auto motion = PredictContact(contact, 14 * kSecond_us);
  ASSERT_TRUE(motion);
  EXPECT_TRUE(motion->position_m.isApprox(Eigen::Vector3d(18, 16, 7)));
  EXPECT_EQ(motion->velocity_mps, Eigen::Vector3d(2, -1, 0.5));
}

TEST(Prediction, IsTheReportItselfUntilTimeHasPassed) {
  const auto motion = PredictContact(ContactReportedAt(10), 9 * kSecond_us);
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->position_m, Eigen::Vector3d(10, 20, 5));
}

TEST(Prediction, KnowsNothingOfAContactThatIsNeitherPlacedNorReported) {
  EXPECT_FALSE(PredictContact(SwarmContact{.id = 2}, kSecond_us));
}

TEST(Prediction, IsNotMadeFromASentinel) {
  SwarmContact lost = ContactReportedAt(10);
  lost.report.now.position_m.setConstant(SentinelValues().position_m);
  EXPECT_FALSE(PredictContact(lost, 11 * kSecond_us));
  SwarmContact adrift = ContactReportedAt(10);
  adrift.report.now.velocity_mps.setConstant(SentinelValues().speed_mps);
  EXPECT_FALSE(PredictContact(adrift, 11 * kSecond_us));
  EXPECT_FALSE(PredictContact(ContactReportedAt(-1), 11 * kSecond_us));
}

TEST(GroupState, FindsItsMembersOnly) {
  GroupState state{.own_id = 3, .members = {SwarmContact{.id = 2}}};
  EXPECT_EQ(FindMember(state, 2), &state.members[0]);
  EXPECT_EQ(FindMember(state, 3), nullptr);
  EXPECT_EQ(FindMember(state, -1), nullptr);
}

}  // namespace shoal::group_state_test
