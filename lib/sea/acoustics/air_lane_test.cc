#include "lib/sea/acoustics/air_lane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace shoal::air_lane_test {

std::vector<int32_t> Overlapping(const AirLane& lane, const AirLane::Ticket& ticket,
                                 int64_t limit) {
  std::vector<int32_t> found;
  lane.ForOverlapping(ticket, limit,
                      [&](const AirLane::Packet& other) { found.push_back(other.transmission); });
  return found;
}

TEST(AirLane, KnowsWhatOverlappedAPacketEvenAfterItEnded) {
  AirLane lane;
  std::vector<int32_t> unneeded;
  const AirLane::Ticket early = lane.Start({0, 2, 10});
  const AirLane::Ticket middle = lane.Start({1, 4, 11});
  lane.End(early, &unneeded);
  EXPECT_TRUE(unneeded.empty());  // It overlaps one that is on the air.
  const AirLane::Ticket late = lane.Start({3, 5, 12});
  EXPECT_EQ(lane.NumOverlapping(middle), 2);
  EXPECT_EQ(Overlapping(lane, middle, 9), (std::vector<int32_t>{10, 12}));
  EXPECT_EQ(Overlapping(lane, middle, 1), (std::vector<int32_t>{10}));
  lane.End(middle, &unneeded);
  EXPECT_EQ(unneeded, (std::vector<int32_t>{10}));
  EXPECT_EQ(Overlapping(lane, late, 9), (std::vector<int32_t>{11}));
  EXPECT_FALSE(lane.IsIdle());
  lane.End(late, &unneeded);
  EXPECT_EQ(unneeded, (std::vector<int32_t>{10, 11, 12}));
  EXPECT_TRUE(lane.IsIdle());
}

TEST(AirLane, KeepsNoMorePacketsThanOverlapThoseOnTheAirHoweverLongItIsBusy) {
  AirLane lane;
  std::vector<int32_t> unneeded;
  std::vector<AirLane::Ticket> on_air;
  constexpr int kPackets = 10'000;
  for (int i = 0; i < kPackets; ++i) {  // A packet starts every second and takes 2.5 s.
    if (i >= 3) lane.End(on_air[static_cast<size_t>(i - 3)], &unneeded);
    on_air.push_back(lane.Start({1.0 * i, i + 2.5, i}));
    ASSERT_FALSE(lane.IsIdle());
    const int64_t num_kept = i + 1 - static_cast<int64_t>(unneeded.size());
    ASSERT_LE(num_kept, 6);
    ASSERT_EQ(lane.NumOverlapping(on_air.back()), std::min(i, 2));
  }
  EXPECT_TRUE(std::ranges::is_sorted(unneeded));  // Each once.
  EXPECT_EQ(std::ranges::adjacent_find(unneeded), unneeded.end());
}

}  // namespace shoal::air_lane_test
