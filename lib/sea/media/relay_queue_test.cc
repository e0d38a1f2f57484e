#include "lib/sea/media/relay_queue.h"

#include <gtest/gtest.h>

namespace shoal::relay_queue_test {

RelayKey KeyOf(int64_t number) { return {"report", "alpha", number}; }

TEST(RelayQueue, ForwardsEachTransmissionOnce) {
  RelayQueue<int> queue({});
  EXPECT_EQ(queue.Offer(KeyOf(1), 0, 10), RelayOffer::kWaits);
  EXPECT_EQ(queue.Offer(KeyOf(1), 1, 11), RelayOffer::kRepeated);
  EXPECT_EQ(queue.Take(0), 10);
  EXPECT_EQ(queue.Take(1'000'000), std::nullopt);
  EXPECT_EQ(queue.Offer(KeyOf(1), 0, 12), RelayOffer::kRepeated) << "after it has left, too";
}

TEST(RelayQueue, ForwardsWhatHasComeByFewerGatewaysThanItsLimit) {
  RelayQueue<int> queue({.max_hops = 2});
  EXPECT_EQ(queue.Offer(KeyOf(1), 1, 0), RelayOffer::kWaits);
  EXPECT_EQ(queue.Offer(KeyOf(2), 2, 0), RelayOffer::kTooManyHops);
  EXPECT_EQ(queue.Offer(KeyOf(3), 3, 0), RelayOffer::kTooManyHops);
}

TEST(RelayQueue, HoldsAsManyAsItsSize) {
  RelayQueue<int> queue({.size = 2});
  EXPECT_EQ(queue.Offer(KeyOf(1), 0, 1), RelayOffer::kWaits);
  EXPECT_EQ(queue.Offer(KeyOf(2), 0, 2), RelayOffer::kWaits);
  EXPECT_EQ(queue.Offer(KeyOf(3), 0, 3), RelayOffer::kFull);
  EXPECT_EQ(queue.Take(0), 1);
  EXPECT_EQ(queue.Offer(KeyOf(3), 0, 3), RelayOffer::kWaits) << "it comes again by another way";
}

TEST(RelayQueue, KeepsItsRateWhateverTheStep) {
  for (const int64_t step_us : {10'000, 70'000, 100'000}) {
    RelayQueue<int> queue({.size = 1000, .rate_hz = 4});
    for (int i = 0; i < 1000; ++i) (void)queue.Offer(KeyOf(i), 0, i);
    int num_taken = 0;
    for (int64_t utime = 0; utime < 50'000'000; utime += step_us) {
      while (queue.Take(utime)) ++num_taken;
    }
    EXPECT_NEAR(num_taken, 200, 1) << step_us;
  }
}

TEST(RelayQueue, SavesNoRateWhileNothingWaits) {
  RelayQueue<int> queue({.rate_hz = 1});
  for (int i = 0; i < 5; ++i) (void)queue.Offer(KeyOf(i), 0, i);
  int num_taken = 0;
  while (queue.Take(100'000'000)) ++num_taken;
  EXPECT_LE(num_taken, 2) << "a long silence is no credit";
}

}  // namespace shoal::relay_queue_test
