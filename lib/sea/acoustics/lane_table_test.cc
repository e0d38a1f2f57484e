#include "lib/sea/acoustics/lane_table.h"

#include <gtest/gtest.h>

#include <vector>

#include "lib/sea/acoustics/transmission_store.h"

namespace shoal::lane_table_test {

TEST(LaneTable, HasOneLaneForAReceiverAndChannel) {
  LaneTable lanes;
  const int32_t first = lanes.FindOrOpen(1, 0, 0);
  EXPECT_EQ(lanes.FindOrOpen(1, 0, 0), first);
  EXPECT_NE(lanes.FindOrOpen(1, 1, 0), first);
  EXPECT_NE(lanes.FindOrOpen(0, 1, 0), first);
  EXPECT_EQ(lanes.num_places(), 3U);
}

TEST(LaneTable, UsesTheLanesOfSilentReceiversAgainAndKeepsThoseInUse) {
  LaneTable lanes;
  const int32_t busy = lanes.FindOrOpen(0, 0, 0);
  lanes[busy].Start({.start_s = 0, .end_s = 1, .transmission = 7});
  for (int32_t receiver = 1; receiver < 100'000; ++receiver) lanes.FindOrOpen(receiver, 0, 0);
  EXPECT_LT(lanes.num_places(), 2000U);
  EXPECT_EQ(lanes.FindOrOpen(0, 0, 0), busy);
  EXPECT_FALSE(lanes[busy].IsIdle());
}

TEST(TransmissionStore, KeepsBytesWithoutUsersUntilItRecycles) {
  TransmissionStore store;
  const std::vector<uint8_t> bytes = {1, 2, 3};
  const int32_t first = store.Take(bytes);
  store[first].num_users = 2;
  store.Release(first);
  store.Recycle();
  const int32_t second = store.Take(bytes);
  EXPECT_NE(second, first) << "it has a user still";
  store.Release(first);
  EXPECT_EQ(store[first].bytes, bytes);
  store.Recycle();
  EXPECT_EQ(store.Take(bytes), first);
  EXPECT_EQ(store.num_places(), 2U);
}

}  // namespace shoal::lane_table_test
