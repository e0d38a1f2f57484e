// The acoustic network where sound bends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/sea/acoustics/validate_options.h"
#include "lib/sea/acoustics/water_testing.h"

namespace shoal::ray_network_test {

const Bytes kPacket(32, 0x5a);

AcousticOptions RayOptions() {
  AcousticOptions options = IdealOptions(AccessMode::kShared);
  options.modem = TestModem();
  options.packet_loss_model = PacketLossModel::kModem;
  options.data_rate_bps = options.modem->data_rate_bps;
  options.base_freq_khz = 28;
  options.bandwidth_khz = 8;
  options.channel_bandwidth_khz = 8;
  options.guard_band_khz = 0;
  options.rays.emplace();
  options.rays->profile = {{0, 1520}, {20, 1519}, {30, 1490}, {100, 1488}};
  options.rays->bottom = {1488, 1, 0};
  options.rays->window_s = 0.05;
  return options;
}

Reception SendOne(const AcousticOptions& options, const Positions& positions_m,
                  const PacketOptions& packet = {}) {
  AcousticNetwork network(options, 1, TestNodes(2));
  const std::vector<int> receivers = {1};
  network.Transmit(0, 0, positions_m, kPacket, receivers, packet);
  const std::vector<Arrived> arrived = DeliverAll(&network);
  EXPECT_EQ(arrived.size(), 1U);
  return arrived.front().reception;
}

TEST(RayNetwork, TakesTheTimeOfItsFirstArrival) {
  const Reception reception = SendOne(RayOptions(), {{0, 0, 60}, {300, 0, 80}});
  EXPECT_EQ(reception.fate, AcousticFate::kDelivered);
  ASSERT_TRUE(reception.rays.has_value());
  EXPECT_EQ(reception.rays->shadow, ShadowReason::kNone);
  EXPECT_NEAR(reception.travel_s, std::hypot(300, 20) / 1488.7, 1e-4);
  EXPECT_EQ(reception.start_s, reception.travel_s);
  EXPECT_GT(*reception.snr_db, 10);
}

TEST(RayNetwork, LosesInAShadowZoneWithTheReason) {
  const Reception reception = SendOne(RayOptions(), {{0, 0, 60}, {3000, 0, 5}});
  EXPECT_EQ(reception.fate, AcousticFate::kShadowZone);
  ASSERT_TRUE(reception.rays.has_value());
  EXPECT_EQ(reception.rays->shadow, ShadowReason::kBendsDown);
  EXPECT_EQ(reception.rays->num_arrivals, 0);
  EXPECT_FALSE(reception.snr_db.has_value());
  EXPECT_EQ(reception.travel_s, -1);
}

TEST(RayNetwork, NamesTheShadowWhereTheBoundariesReturnTooLittle) {
  AcousticOptions options = RayOptions();
  options.rays->bottom = *FindBottomType("mud");
  options.modem->source_level_db = 140;
  const Reception reception = SendOne(options, {{0, 0, 60}, {3000, 0, 5}});
  EXPECT_EQ(reception.fate, AcousticFate::kShadowZone);
  EXPECT_GT(reception.rays->num_arrivals, 0);
  EXPECT_GT(reception.loss_probability, 0.5);
}

TEST(RayNetwork, CountsEachShadowAsAFate) {
  AcousticNetwork network(RayOptions(), 1, TestNodes(2));
  const std::vector<int> receivers = {1};
  network.Transmit(0, 0, Positions{{0, 0, 60}, {3000, 0, 5}}, kPacket, receivers);
  EXPECT_EQ(network.statistics().num_in_transit, 1);
  DeliverAll(&network);
  const AcousticStatistics statistics = network.statistics();
  EXPECT_EQ(statistics.NumOf(AcousticFate::kShadowZone), 1);
  EXPECT_EQ(statistics.num_in_transit, 0);
  EXPECT_NE(StatisticsText(statistics).find("shadow_zone"), std::string::npos);
  EXPECT_EQ(StatisticsText(AcousticStatistics()).find("shadow_zone"), std::string::npos);
}

TEST(RayNetwork, DoesNotCollideWithWhatDoesNotArrive) {
  AcousticOptions options = RayOptions();
  options.collisions = CollisionModel::kDrop;
  AcousticNetwork network(options, 1, TestNodes(3));
  const Positions positions_m = {{0, 0, 60}, {3000, 0, 5}, {3200, 0, 6}};
  const std::vector<int> receivers = {1};
  network.Transmit(0, 0, positions_m, kPacket, receivers);    // Into the shadow.
  network.Transmit(1.9, 2, positions_m, kPacket, receivers);  // There at the same time.
  const std::vector<Arrived> arrived = DeliverAll(&network);
  ASSERT_EQ(arrived.size(), 2U);
  for (const Arrived& each : arrived) {
    EXPECT_EQ(each.reception.fate, each.reception.packet.source == 2 ? AcousticFate::kDelivered
                                                                     : AcousticFate::kShadowZone);
  }
}

TEST(RayNetwork, LosesByTheUsersPacketErrorTable) {
  AcousticOptions options = RayOptions();
  options.rays->packet_errors = {{-50, 1}, {200, 1}};
  const Positions positions_m = {{0, 0, 60}, {300, 0, 80}};
  const Reception lost = SendOne(options, positions_m);
  EXPECT_EQ(lost.fate, AcousticFate::kLost);
  EXPECT_EQ(lost.loss_probability, 1);
  options.rays->packet_errors = {{-50, 0}, {200, 0}};
  EXPECT_EQ(SendOne(options, positions_m).fate, AcousticFate::kDelivered);
}

TEST(RayNetwork, LosesAFastReceiverBeyondTheModemsDoppler) {
  AcousticOptions options = RayOptions();
  options.rays->max_doppler_mps = 3;
  const Positions positions_m = {{0, 0, 60}, {300, 0, 80}};
  const Positions velocities_mps = {{2, 0, 0}, {-2, 0, 0}};
  const Reception reception = SendOne(options, positions_m, {.velocities_mps = velocities_mps});
  EXPECT_EQ(reception.fate, AcousticFate::kLost);
  EXPECT_NEAR(reception.rays->doppler_mps, 4, 0.05);
  EXPECT_EQ(reception.rays->shadow, ShadowReason::kNone);
}

TEST(RayNetwork, ReceivesAtALowRateWhatInterferesAtAHighOne) {
  // Late echoes as strong as the signal: a slow bit has the energy to stand them.
  AcousticOptions options = RayOptions();
  options.modem->code = {};
  options.modem->fading = Fading::kNone;
  options.rays->profile = {{0, 1500}};
  options.rays->bottom = *FindBottomType("rock");
  options.rays->bottom_depth_m = 20;
  options.rays->window_s = 0.001;
  const Positions positions_m = {{0, 0, 10}, {400, 0, 12}};
  const Reception fast = SendOne(options, positions_m, {.data_rate_bps = 8000});
  const Reception slow = SendOne(options, positions_m, {.data_rate_bps = 80});
  EXPECT_EQ(fast.snr_db, slow.snr_db);
  EXPECT_LT(*fast.snr_db, 5);
  EXPECT_GT(fast.loss_probability, 0.9);
  EXPECT_LT(slow.loss_probability, 0.1);
}

TEST(RayNetwork, NeedsAModem) {
  AcousticOptions options = RayOptions();
  EXPECT_TRUE(FindProblems(options, TestNodes(2)).empty());
  options.packet_loss_model = PacketLossModel::kOff;
  const auto problems = FindProblems(options, TestNodes(2));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].option, "channel");
}

}  // namespace shoal::ray_network_test
