// Packets on a channel that their sender chooses.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "lib/sea/acoustics/acoustic_network.h"
#include "lib/sea/acoustics/water_testing.h"

namespace shoal::chosen_channel_test {

constexpr int kNumNodes = 4;
const Positions kHere(kNumNodes, Eigen::Vector3d::Zero());

AcousticNetwork FdmaWithCollisions() {
  AcousticOptions options = IdealOptions(AccessMode::kFdma);
  options.collisions = CollisionModel::kDrop;
  return AcousticNetwork(options, 1, TestNodes(kNumNodes));
}

/// What the last node, which sends nothing, gets of each packet's source.
std::map<int, Reception> AtTheLast(AcousticNetwork* network) {
  std::map<int, Reception> receptions;
  for (const Arrived& arrived : DeliverAll(network)) {
    if (arrived.reception.receiver != kNumNodes - 1) continue;
    receptions[arrived.reception.packet.source] = arrived.reception;
  }
  return receptions;
}

TEST(ChosenChannel, CollidesWithPacketsOnTheSameChannelOnly) {
  AcousticNetwork network = FdmaWithCollisions();
  const int chosen = network.plan().SendsOn(1);
  network.Transmit(0, 0, kHere, Bytes(10), AllOf(network), {.channel = chosen});
  network.Transmit(0, 1, kHere, Bytes(10), AllOf(network));
  network.Transmit(0, 2, kHere, Bytes(10), AllOf(network));
  const std::map<int, Reception> receptions = AtTheLast(&network);
  EXPECT_EQ(receptions.at(0).fate, AcousticFate::kCollided);
  EXPECT_EQ(receptions.at(1).fate, AcousticFate::kCollided);
  EXPECT_EQ(receptions.at(2).fate, AcousticFate::kDelivered);
}

TEST(ChosenChannel, LeavesTheSendersOwnChannelFree) {
  AcousticNetwork network = FdmaWithCollisions();
  network.Transmit(0, 0, kHere, Bytes(10), AllOf(network), {.channel = network.plan().SendsOn(1)});
  network.Transmit(0, 2, kHere, Bytes(10), AllOf(network), {.channel = network.plan().SendsOn(0)});
  const std::map<int, Reception> receptions = AtTheLast(&network);
  EXPECT_EQ(receptions.at(0).fate, AcousticFate::kDelivered);
  EXPECT_EQ(receptions.at(2).fate, AcousticFate::kDelivered);
}

TEST(ChosenChannel, IsThatOfTheReception) {
  AcousticNetwork network = FdmaWithCollisions();
  const int chosen = network.plan().SendsOn(2);
  network.Transmit(0, 0, kHere, Bytes(10), AllOf(network), {.channel = chosen});
  EXPECT_EQ(AtTheLast(&network).at(0).channel, chosen);
}

TEST(ChosenChannel, IsNotReceivedByTheVehicleThatSendsOnIt) {
  AcousticNetwork network = FdmaWithCollisions();
  network.Transmit(0, 0, kHere, Bytes(10), AllOf(network),
                   {.channel = network.plan().SendsOn(kNumNodes - 1)});
  EXPECT_EQ(AtTheLast(&network).at(0).fate, AcousticFate::kNotListening);
}

}  // namespace shoal::chosen_channel_test
