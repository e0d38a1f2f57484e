#include "lib/sea/acoustics/acoustic_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "lib/sea/acoustics/water_testing.h"

namespace shoal::acoustic_network_test {

constexpr int kAlpha = 0;
constexpr int kBravo = 1;

const Positions kInARow = {{0, 0, 0}, {1500, 0, 0}, {3000, 0, 0}};

TEST(AcousticNetwork, ReportsTheNumbersThatDecided) {
  AcousticNetwork network(IdealOptions(AccessMode::kFdma), 1, TestNodes(3));
  const Bytes bytes = {1, 2, 3, 4, 5};
  EXPECT_EQ(network.Transmit(10, kBravo, kInARow, bytes, AllOf(network)), 0);
  EXPECT_EQ(network.num_in_transit(), 2);
  EXPECT_TRUE(network.Deliver(11.03).empty());
  const std::vector<Arrived> arrived = DeliverAll(&network);
  ASSERT_EQ(arrived.size(), 2U);
  const Reception& reception = arrived[0].reception;
  EXPECT_EQ(reception.packet, (PacketId{kBravo, 0}));
  EXPECT_EQ(reception.receiver, kAlpha);
  EXPECT_EQ(network.plan().channel(reception.channel).id, 2);
  EXPECT_EQ(reception.fate, AcousticFate::kDelivered);
  EXPECT_DOUBLE_EQ(reception.sent_s, 10);
  EXPECT_DOUBLE_EQ(reception.air_s, 0.04);
  EXPECT_DOUBLE_EQ(reception.travel_s, 1);
  EXPECT_DOUBLE_EQ(reception.jitter_s, 0);
  EXPECT_DOUBLE_EQ(reception.start_s, 11);
  EXPECT_DOUBLE_EQ(reception.end_s, 11.04);
  EXPECT_DOUBLE_EQ(reception.range_m, 1500);
  EXPECT_EQ(reception.loss_probability, -1);
  EXPECT_EQ(reception.bit_error_probability, -1);
  EXPECT_EQ(arrived[0].bytes, bytes);
}

TEST(AcousticNetwork, NumbersThePacketsOfEachSource) {
  AcousticNetwork network({}, 1, TestNodes(3));
  EXPECT_EQ(network.Transmit(0, kAlpha, kInARow, Bytes(1), {}), 0);
  EXPECT_EQ(network.Transmit(0, kBravo, kInARow, Bytes(1), {}), 0);
  EXPECT_EQ(network.Transmit(0, kAlpha, kInARow, Bytes(1), {}), 1);
}

TEST(AcousticNetwork, SendsToNoReceiverWithoutComplaint) {
  AcousticNetwork network({}, 1, TestNodes(1));
  const Positions here = {Eigen::Vector3d::Zero()};
  network.Transmit(0, kAlpha, here, Bytes(37), AllOf(network));
  EXPECT_TRUE(network.Deliver(100).empty());
  EXPECT_EQ(network.statistics().num_transmissions, 1);
  EXPECT_EQ(network.statistics().num_offered, 0);
}

TEST(AcousticNetwork, OffersAPacketOncePerReceiverAndNotToItsSource) {
  AcousticNetwork network(IdealOptions(AccessMode::kShared), 1, TestNodes(3));
  const std::vector<int> receivers = {kBravo, kAlpha, kBravo, kBravo};
  network.Transmit(0, kAlpha, kInARow, Bytes(3), receivers);
  EXPECT_EQ(network.statistics().num_offered, 1);
  EXPECT_EQ(DeliverAll(&network).size(), 1U);
}

TEST(AcousticNetwork, TakesPositionsFromTheMomentOfSending) {
  AcousticNetwork network(IdealOptions(AccessMode::kShared), 1, TestNodes(3));
  const std::vector<int> to_bravo = {kBravo};
  network.Transmit(0, kAlpha, kInARow, Bytes(125), to_bravo);
  const Positions elsewhere(3, Eigen::Vector3d::Zero());
  network.Transmit(0.5, kAlpha, elsewhere, Bytes(125), to_bravo);
  const std::vector<Arrived> arrived = DeliverAll(&network);
  ASSERT_EQ(arrived.size(), 2U);
  EXPECT_EQ(arrived[0].reception.packet.number, 1);
  EXPECT_DOUBLE_EQ(arrived[0].reception.end_s, 1.5);
  EXPECT_DOUBLE_EQ(arrived[1].reception.end_s, 2);
}

TEST(AcousticNetwork, HasNoPathToPlacesThatAreNotKnownOrNotOnEarth) {
  AcousticNetwork network(IdealOptions(AccessMode::kShared), 1, TestNodes(3));
  for (const double x_m : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), -1e300, 2.2e7}) {
    const double now_s = 10.0 * static_cast<double>(network.statistics().num_transmissions);
    network.Transmit(now_s, kAlpha, Positions{{0, 0, 0}, {x_m, 0, 0}, {1500, 0, 0}}, Bytes(125),
                     AllOf(network));
    const std::vector<Arrived> arrived = DeliverAll(&network, now_s + 2);
    ASSERT_EQ(arrived.size(), 2U);
    EXPECT_EQ(arrived[0].reception.fate, AcousticFate::kNoPath);
    EXPECT_DOUBLE_EQ(arrived[0].reception.end_s, now_s + 1);  // When the source is done.
    EXPECT_EQ(arrived[0].reception.range_m, -1);
    EXPECT_EQ(arrived[1].reception.fate, AcousticFate::kDelivered);
  }
}

TEST(AcousticNetwork, DeliversNothingOnAChannelThatNoNodeReceivesOn) {
  AcousticNetwork network(IdealOptions(AccessMode::kTdmaLf), 1, TestNodes(3));  // Alpha leads.
  network.Transmit(0, kBravo, kInARow, Bytes(1), AllOf(network));
  const std::vector<Arrived> arrived = DeliverAll(&network);
  ASSERT_EQ(arrived.size(), 2U);
  EXPECT_EQ(arrived[0].reception.receiver, 2);
  EXPECT_EQ(arrived[0].reception.fate, AcousticFate::kNotListening);
  EXPECT_EQ(arrived[1].reception.receiver, kAlpha);
  EXPECT_EQ(arrived[1].reception.fate, AcousticFate::kDelivered);
}

TEST(AcousticNetwork, KnowsBeforeWhenNothingHappens) {
  AcousticNetwork network(IdealOptions(AccessMode::kFdma), 1, TestNodes(3));
  EXPECT_EQ(network.NextEvent_s(), std::numeric_limits<double>::infinity());
  network.Transmit(10, kAlpha, kInARow, Bytes(5), AllOf(network));
  int num_arrived = 0;
  while (network.num_in_transit() > 0) {
    const double next_s = network.NextEvent_s();
    EXPECT_TRUE(network.Deliver(std::nextafter(next_s, 0)).empty());
    num_arrived += static_cast<int>(network.Deliver(next_s).size());
    EXPECT_GT(network.NextEvent_s(), next_s);
  }
  EXPECT_EQ(num_arrived, 2);
  EXPECT_EQ(network.NextEvent_s(), std::numeric_limits<double>::infinity());
}

TEST(AcousticNetwork, DeliversAnEmptyPacketThatNothingCanHit) {
  AcousticOptions options = IdealOptions(AccessMode::kShared);
  options.collisions = CollisionModel::kDrop;
  options.half_duplex = true;
  AcousticNetwork network(options, 1, TestNodes(3));
  const Positions one_place(3, Eigen::Vector3d::Zero());
  network.Transmit(0, kAlpha, one_place, Bytes(125), AllOf(network));
  network.Transmit(0.5, kBravo, one_place, {}, AllOf(network));
  int num_delivered = 0;
  for (const Arrived& arrived : DeliverAll(&network)) {
    EXPECT_EQ(arrived.reception.fate, AcousticFate::kDelivered);
    ++num_delivered;
  }
  EXPECT_EQ(num_delivered, 4);
}

TEST(AcousticNetwork, LosesPacketsThatAlsoCollideToTheCollision) {
  AcousticOptions options = IdealOptions(AccessMode::kShared);
  options.collisions = CollisionModel::kDrop;
  options.packet_loss_model = PacketLossModel::kUniform;
  options.packet_loss = 1;
  AcousticNetwork network(options, 1, TestNodes(3));
  const std::vector<int> to_bravo = {kBravo};
  network.Transmit(0, kAlpha, kInARow, Bytes(125), to_bravo);
  network.Transmit(0.5, 2, kInARow, Bytes(125), to_bravo);
  network.Transmit(5, kAlpha, kInARow, Bytes(125), to_bravo);
  const std::vector<Arrived> arrived = DeliverAll(&network);
  ASSERT_EQ(arrived.size(), 3U);
  EXPECT_EQ(arrived[0].reception.fate, AcousticFate::kCollided);
  EXPECT_EQ(arrived[0].reception.num_colliders, 1);
  EXPECT_EQ(arrived[0].reception.colliders[0], (PacketId{2, 0}));
  EXPECT_EQ(arrived[1].reception.fate, AcousticFate::kCollided);
  EXPECT_EQ(arrived[1].reception.colliders[0], (PacketId{kAlpha, 0}));
  EXPECT_EQ(arrived[2].reception.fate, AcousticFate::kLost);
  EXPECT_EQ(arrived[2].reception.loss_probability, 1);
}

TEST(AcousticNetwork, CallsTwinsThatCancelEachOtherDamaged) {
  AcousticOptions options = IdealOptions(AccessMode::kShared);
  options.collisions = CollisionModel::kCorrupt;
  AcousticNetwork network(options, 1, TestNodes(4));
  const Positions one_place(4, Eigen::Vector3d::Zero());
  const std::vector<int> to_bravo = {kBravo};
  const Bytes bytes = {1, 2, 3};
  network.Transmit(0, kAlpha, one_place, bytes, to_bravo);
  network.Transmit(0, 2, one_place, bytes, to_bravo);
  for (const Arrived& arrived : DeliverAll(&network)) {
    EXPECT_EQ(arrived.reception.fate, AcousticFate::kDamagedByCollision);
    EXPECT_EQ(arrived.bytes, Bytes(3, 0));
  }
  // A third twin restores what two of them cancelled.
  for (const int source : {kAlpha, 2, 3}) network.Transmit(1e9, source, one_place, bytes, to_bravo);
  const std::vector<Arrived> arrived = DeliverAll(&network, 2e9);
  ASSERT_EQ(arrived.size(), 3U);
  EXPECT_EQ(arrived[0].reception.num_colliders, 2);
  EXPECT_EQ(arrived[0].reception.fate, AcousticFate::kDelivered);
  EXPECT_EQ(network.statistics().num_collided, 5);
}

TEST(AcousticNetwork, TakesNodesInLaterWhileThereAreChannels) {
  AcousticNetwork network(IdealOptions(AccessMode::kFdma), 1, TestNodes(6));
  EXPECT_FALSE(network.AddNode({.name = "node_3"}).ok());
  const Result<int> seventh = network.AddNode({.name = "late", .address = 9});
  ASSERT_TRUE(seventh.ok());
  EXPECT_EQ(*seventh, 6);
  EXPECT_FALSE(network.AddNode({.name = "too_late", .address = 10}).ok());
  EXPECT_EQ(network.num_nodes(), 7);
  const Positions one_place(7, Eigen::Vector3d::Zero());
  network.Transmit(0, 6, one_place, Bytes(1), AllOf(network));
  EXPECT_EQ(DeliverAll(&network).size(), 6U);
}

TEST(AcousticNetwork, RemembersWhatIsOnTheAirWhileThousandsOfLinksComeAndGo) {
  AcousticOptions options = IdealOptions(AccessMode::kFdma);
  options.collisions = CollisionModel::kDrop;
  options.bandwidth_khz = 130;
  options.base_freq_khz = 100;
  constexpr int kNodes = 60;  // 3540 links.
  AcousticNetwork network(options, 1, TestNodes(kNodes));
  const Positions one_place(kNodes, Eigen::Vector3d::Zero());
  const std::vector<int> all = AllOf(network);
  network.Transmit(0, kAlpha, one_place, Bytes(125 * 100), all);  // Takes 100 s.
  for (int i = 1; i < kNodes; ++i) {
    network.Transmit(i, i, one_place, Bytes(1), all);
    const std::vector<Arrived> short_ones = DeliverAll(&network, i + 0.5);
    EXPECT_EQ(short_ones.size(), static_cast<size_t>(kNodes - 1));
    for (const Arrived& one : short_ones) {
      EXPECT_EQ(one.reception.fate, AcousticFate::kDelivered);
    }
  }
  network.Transmit(70, kAlpha, one_place, Bytes(1), all);
  const std::vector<Arrived> arrived = DeliverAll(&network);
  EXPECT_EQ(arrived.size(), 2U * (kNodes - 1));
  for (const Arrived& one : arrived) EXPECT_EQ(one.reception.fate, AcousticFate::kCollided);
}

TEST(AcousticNetwork, NeedsNoMoreMemoryTheLongerItRuns) {
  AcousticOptions options;
  options.access_mode = AccessMode::kShared;
  options.collisions = CollisionModel::kCorrupt;
  options.half_duplex = true;
  AcousticNetwork network(options, 1, TestNodes(3));
  const std::vector<int> all = AllOf(network);
  for (int i = 0; i < 3000; ++i) {  // Never silent: a packet of 0.3 s every 0.1 s.
    network.Transmit(0.1 * i, i % 3, kInARow, Bytes(37), all);
    network.Deliver(0.1 * i);
    EXPECT_LE(network.num_in_transit(), 60);
  }
  EXPECT_LT(network.NumPlaces(), 200U);
}

TEST(AcousticNetwork, CarriesAPacketOfAMegabyte) {
  AcousticOptions options = IdealOptions(AccessMode::kShared);
  options.bit_error_model = BitErrorModel::kPoisson;
  AcousticNetwork network(options, 1, TestNodes(2));
  network.Transmit(0, kAlpha, Positions(2, Eigen::Vector3d::Zero()), Bytes(1 << 20),
                   AllOf(network));
  const std::vector<Arrived> arrived = DeliverAll(&network);
  ASSERT_EQ(arrived.size(), 1U);
  EXPECT_EQ(arrived[0].bytes.size(), size_t{1} << 20);
  EXPECT_NEAR(static_cast<double>(arrived[0].reception.num_bits_flipped), 8389, 500);
}

TEST(AcousticNetwork, CountsWhatReceiversReject) {
  AcousticNetwork network({}, 1, TestNodes(2));
  network.CountRejection();
  EXPECT_EQ(network.statistics().num_rejected, 1);
}

}  // namespace shoal::acoustic_network_test
