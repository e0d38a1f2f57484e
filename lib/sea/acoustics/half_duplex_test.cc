#include <gtest/gtest.h>

#include <vector>

#include "lib/sea/acoustics/water_testing.h"

namespace shoal::half_duplex_test {

constexpr int kAlpha = 0;
constexpr int kBravo = 1;
constexpr int kCharlie = 2;

AcousticOptions HalfDuplex() {
  AcousticOptions options = IdealOptions(AccessMode::kFdma);
  options.half_duplex = true;
  return options;
}

/// Alpha, bravo 1500 m, that is 1 s, away from it, and charlie as far beyond.
const Positions kInARow = {{0, 0, 0}, {1500, 0, 0}, {3000, 0, 0}};
const Bytes kOneSecond(125);

TEST(HalfDuplex, DropsWhatArrivesWhileTheReceiverSends) {
  AcousticNetwork network(HalfDuplex(), 1, TestNodes(3));
  network.Transmit(0, kAlpha, kInARow, kOneSecond, AllOf(network));    // At bravo from 1 s to 2 s.
  network.Transmit(1.5, kBravo, kInARow, kOneSecond, AllOf(network));  // From 1.5 s to 2.5 s.
  const std::vector<Arrived> arrived = DeliverAll(&network);
  ASSERT_EQ(arrived.size(), 4U);
  EXPECT_EQ(arrived[0].reception.receiver, kBravo);
  EXPECT_EQ(arrived[0].reception.fate, AcousticFate::kHalfDuplex);
  EXPECT_EQ(arrived[0].reception.own_number, 0);
  EXPECT_TRUE(arrived[0].bytes.empty());
  for (size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(arrived[i].reception.fate, AcousticFate::kDelivered);
    EXPECT_EQ(arrived[i].reception.own_number, -1);
  }
}

TEST(HalfDuplex, LetsThroughWhatOnlyTouchesATransmissionOfTheReceivers) {
  AcousticNetwork network(HalfDuplex(), 1, TestNodes(3));
  network.Transmit(0, kBravo, kInARow, kOneSecond, {});  // Until 1 s.
  network.Transmit(0, kAlpha, kInARow, kOneSecond, AllOf(network));
  network.Transmit(2, kBravo, kInARow, kOneSecond, {});  // From 2 s on.
  for (const Arrived& arrived : DeliverAll(&network)) {
    EXPECT_EQ(arrived.reception.fate, AcousticFate::kDelivered);
  }
}

TEST(HalfDuplex, IsOffByDefault) {
  AcousticNetwork network(IdealOptions(AccessMode::kFdma), 1, TestNodes(3));
  network.Transmit(0, kAlpha, kInARow, kOneSecond, AllOf(network));
  network.Transmit(1.5, kBravo, kInARow, kOneSecond, AllOf(network));
  for (const Arrived& arrived : DeliverAll(&network)) {
    EXPECT_EQ(arrived.reception.fate, AcousticFate::kDelivered);
  }
}

TEST(HalfDuplex, RemembersALongTransmissionBehindAShortOne) {
  AcousticNetwork network(HalfDuplex(), 1, TestNodes(3));
  network.Transmit(0, kBravo, kInARow, Bytes(1250), {});  // Until 10 s.
  network.Transmit(1, kBravo, kInARow, Bytes(1), {});
  network.Transmit(3, kAlpha, kInARow, kOneSecond, AllOf(network));
  const std::vector<Arrived> arrived = DeliverAll(&network);
  ASSERT_EQ(arrived.size(), 2U);
  EXPECT_EQ(arrived[0].reception.fate, AcousticFate::kHalfDuplex);
  EXPECT_EQ(arrived[0].reception.own_number, 0);
  EXPECT_EQ(arrived[1].reception.receiver, kCharlie);
  EXPECT_EQ(arrived[1].reception.fate, AcousticFate::kDelivered);
}

TEST(HalfDuplex, DoesNotKeepWhatIsNotReceivedFromSpoilingOtherPackets) {
  AcousticOptions options = HalfDuplex();
  options.access_mode = AccessMode::kShared;
  options.collisions = CollisionModel::kDrop;
  AcousticNetwork network(options, 1, TestNodes(3));
  const std::vector<int> to_bravo = {kBravo};
  network.Transmit(0, kBravo, kInARow, Bytes(175), {});            // From 0 s to 1.4 s.
  network.Transmit(0, kAlpha, kInARow, kOneSecond, to_bravo);      // At bravo from 1 s to 2 s.
  network.Transmit(0.5, kCharlie, kInARow, kOneSecond, to_bravo);  // From 1.5 s to 2.5 s.
  const std::vector<Arrived> arrived = DeliverAll(&network);
  ASSERT_EQ(arrived.size(), 2U);
  EXPECT_EQ(arrived[0].reception.fate, AcousticFate::kHalfDuplex);
  EXPECT_EQ(arrived[1].reception.fate, AcousticFate::kCollided);
}

}  // namespace shoal::half_duplex_test
