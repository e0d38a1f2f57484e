#include "lib/tools/view/log_index.h"

#include <gtest/gtest.h>

#include "lib/tools/view/recorded_testing.h"

namespace shoal::log_index_test {

LogIndex IndexOf(const TestDirectory& directory, const std::vector<TestEvent>& events) {
  WriteLog(directory.File("a.lcm"), events);
  auto reader = LogReader::Open(directory.File("a.lcm"), OnDamage::kSkip);
  EXPECT_TRUE(reader.ok());
  Scene scene(TrafficMission());
  return BuildLogIndex(&*reader, &scene, TrafficMission(), LogStamps::kMission);
}

TEST(LogIndex, BeginsWithAKeyframeThatHoldsNothing) {
  const TestDirectory directory;
  const LogIndex index = IndexOf(directory, TrafficMaker(1).Make(3));
  ASSERT_EQ(index.keyframes.size(), 1U);
  EXPECT_EQ(index.keyframes[0].offset, 0U);
  EXPECT_TRUE(index.keyframes[0].standing.empty());
  EXPECT_EQ(&index.KeyframeBefore(-5), &index.keyframes[0]);
  EXPECT_EQ(&index.KeyframeBefore(1'000'000'000), &index.keyframes[0]);
}

TEST(LogIndex, FindsTheLastKeyframeThatHoldsNothingLater) {
  const TestDirectory directory;
  const LogIndex index = IndexOf(directory, TrafficMaker(2).Make(600));
  ASSERT_GT(index.keyframes.size(), 10U);
  for (int64_t line_us = 0; line_us <= index.end_us; line_us += 50'000) {
    const Keyframe& keyframe = index.KeyframeBefore(line_us);
    EXPECT_LE(keyframe.timeline.now_us(), line_us);
    if (&keyframe != &index.keyframes.back()) {
      EXPECT_GT((&keyframe + 1)->timeline.now_us(), line_us);
    }
  }
}

TEST(LogIndex, CountsInEachKeyframeTheFatesBeforeIt) {
  const TestDirectory directory;
  const auto events = TrafficMaker(3).Make(600);
  const LogIndex index = IndexOf(directory, events);
  uint64_t offset = 0;
  int64_t num_fates = 0;
  size_t next = 0;
  for (const TestEvent& event : events) {
    if (next < index.keyframes.size() && index.keyframes[next].offset == offset) {
      EXPECT_EQ(index.keyframes[next].num_fates, num_fates);
      EXPECT_EQ(index.keyframes[next].links.num_fates(), num_fates);
      ++next;
    }
    comms_fates_t fates;
    if (event.channel == "COMMS_FATES" && Decode(event.data, &fates)) num_fates += fates.num_fates;
    offset += kLogHeaderSize + event.channel.size() + event.data.size();
  }
  EXPECT_EQ(next, index.keyframes.size());
  EXPECT_EQ(index.num_events, static_cast<int64_t>(events.size()));
}

TEST(LogIndex, KeepsFewKeyframesOfALongLog) {
  const TestDirectory directory;
  std::vector<TestEvent> events;
  const Bytes nav = Encoded(NavAt(0, 1, 2));
  const int64_t num_events = 2 * static_cast<int64_t>(LogIndex::kMaxKeyframes) *
                             static_cast<int64_t>(LogIndex::kLeastGap_bytes) / 200;
  for (int64_t i = 0; i < num_events; ++i) {
    events.push_back({.utime = i * 1000, .channel = "NAV_ALPHA", .data = nav});
  }
  const LogIndex index = IndexOf(directory, events);
  EXPECT_LE(index.keyframes.size(), LogIndex::kMaxKeyframes);
  EXPECT_GE(index.keyframes.size(), LogIndex::kMaxKeyframes / 2);
  EXPECT_EQ(index.keyframes.back().standing.size(), 1U);
}

}  // namespace shoal::log_index_test
