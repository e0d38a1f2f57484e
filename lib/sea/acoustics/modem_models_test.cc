// The acoustic network where its loss or its bit errors are those of a modem.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <map>
#include <tuple>
#include <vector>

#include "lib/sea/acoustics/water_testing.h"

namespace shoal::modem_models_test {

/// A normal variate is farther from 0 than this once in a million times.
constexpr double kNormalLimit = 4.89;

const ModemPreset kCodedModem = TestModem();

ModemPreset PlainModem() {
  ModemPreset modem = kCodedModem;
  modem.code = {};
  return modem;
}

const Sea kSea = {.water = {.temperature_degc = 15}, .noise = {.shipping = 1, .wind_mps = 10}};

AcousticOptions WithModem(const ModemPreset& modem, PacketLossModel packet_loss,
                          BitErrorModel bit_errors) {
  AcousticOptions options = IdealOptions(AccessMode::kShared);
  options.modem = modem;
  options.sea = kSea;
  options.packet_loss_model = packet_loss;
  options.bit_error_model = bit_errors;
  return options;
}

AcousticOptions Lossy() {
  return WithModem(kCodedModem, PacketLossModel::kModem, BitErrorModel::kOff);
}

/// Sends `count` packets, one a second, from node 0 to node 1 at this range.
std::vector<Arrived> SendMany(const AcousticOptions& options, double range_m, int count,
                              size_t num_bytes) {
  AcousticNetwork network(options, 20261121, TestNodes(2));
  const Positions positions_m = {{0, 0, 0}, {range_m, 0, 0}};
  const std::vector<int> receivers = {1};
  for (int i = 0; i < count; ++i) {
    network.Transmit(i, 0, positions_m, Bytes(num_bytes), receivers);
  }
  return DeliverAll(&network);
}

TEST(ModemLoss, IsThatOfTheLinkAndTheLengthOfThePacket) {
  for (const double range_m : {1.0, 500.0, 4000.0, 20'000.0, 2e7}) {
    for (const size_t num_bytes : {0, 1, 37, 64}) {
      const std::vector<Arrived> arrived = SendMany(Lossy(), range_m, 1, num_bytes);
      ASSERT_EQ(arrived.size(), 1U);
      const LinkBudget link = LinkModel(kCodedModem, kSea).At(range_m);
      const Reception& reception = arrived[0].reception;
      EXPECT_EQ(reception.snr_db, link.snr_db);
      EXPECT_TRUE(std::isfinite(*reception.snr_db));
      EXPECT_EQ(reception.loss_probability,
                PacketErrorRate(link.bit_error_rate, num_bytes, kCodedModem.code));
      EXPECT_EQ(reception.bit_error_probability, -1);
      EXPECT_EQ(reception.num_bits_flipped, 0);
    }
  }
}

TEST(ModemLoss, IsTheLessTheSlowerAPacketIs) {
  constexpr double kRange_m = 4000;
  const Positions positions_m = {{0, 0, 0}, {kRange_m, 0, 0}};
  double last = -1;
  for (const double rate_bps : {40.0, 463.0, 5000.0}) {
    AcousticNetwork network(Lossy(), 1, TestNodes(2));
    network.Transmit(0, 0, positions_m, Bytes(37), AllOf(network), {.data_rate_bps = rate_bps});
    const Reception reception = DeliverAll(&network).at(0).reception;
    EXPECT_DOUBLE_EQ(reception.air_s, 8 * 37 / rate_bps);
    const LinkBudget link = LinkModel(kCodedModem, kSea).At(kRange_m, rate_bps);
    EXPECT_EQ(reception.loss_probability,
              PacketErrorRate(link.bit_error_rate, 37, kCodedModem.code));
    EXPECT_GT(reception.loss_probability, last);
    last = reception.loss_probability;
  }
  EXPECT_EQ(LinkModel(kCodedModem, kSea).At(kRange_m),
            LinkModel(kCodedModem, kSea).At(kRange_m, kCodedModem.data_rate_bps));
}

TEST(ModemBitErrors, AreThoseOfTheBitsInTransit) {
  const AcousticOptions options =
      WithModem(PlainModem(), PacketLossModel::kOff, BitErrorModel::kModem);
  const std::vector<Arrived> arrived = SendMany(options, 4000, 1, 37);
  ASSERT_EQ(arrived.size(), 1U);
  const LinkBudget link = LinkModel(PlainModem(), kSea).At(4000);
  EXPECT_EQ(arrived[0].reception.bit_error_probability, link.bit_error_rate);
  EXPECT_EQ(arrived[0].reception.snr_db, link.snr_db);
  EXPECT_EQ(arrived[0].reception.loss_probability, -1);
}

TEST(ModemModels, HaveNoSignalToNoiseRatioWhereNoneIsAskedFor) {
  const AcousticOptions options =
      WithModem(kCodedModem, PacketLossModel::kUniform, BitErrorModel::kPoisson);
  EXPECT_EQ(SendMany(options, 500, 1, 37).at(0).reception.snr_db, std::nullopt);

  AcousticNetwork network(Lossy(), 1, TestNodes(2));
  const double nan = std::nan("");
  network.Transmit(0, 0, Positions{{0, 0, 0}, {nan, 0, 0}}, Bytes(37), AllOf(network));
  const std::vector<Arrived> arrived = DeliverAll(&network);
  EXPECT_EQ(arrived.at(0).reception.fate, AcousticFate::kNoPath);
  EXPECT_EQ(arrived.at(0).reception.snr_db, std::nullopt);
}

TEST(ModemLoss, StrikesAsOftenAsItsProbability) {
  constexpr int kPackets = 5000;
  int num_telling = 0;
  for (const double range_m : {4500.0, 5000.0, 5500.0, 6000.0}) {
    int num_lost = 0;
    double p = 0;
    for (const Arrived& arrived : SendMany(Lossy(), range_m, kPackets, 37)) {
      num_lost += arrived.reception.fate == AcousticFate::kLost ? 1 : 0;
      p = arrived.reception.loss_probability;
    }
    num_telling += p > 0.01 && p < 0.99 ? 1 : 0;
    EXPECT_LE(std::abs(num_lost - kPackets * p),
              kNormalLimit * std::sqrt(kPackets * p * (1 - p)) + 1)
        << range_m << " m: " << num_lost << " with " << p;
  }
  EXPECT_GE(num_telling, 2);
}

TEST(ModemBitErrors, FlipAsManyBitsAsTheirProbabilityPredicts) {
  constexpr int kPackets = 2000;
  constexpr double kBits = kPackets * 37 * 8;
  const AcousticOptions options =
      WithModem(PlainModem(), PacketLossModel::kOff, BitErrorModel::kModem);
  double num_flipped = 0;
  double p = 0;
  for (const Arrived& arrived : SendMany(options, 4000, kPackets, 37)) {
    int num_different = 0;
    for (const uint8_t byte : arrived.bytes) num_different += std::popcount(byte);
    EXPECT_EQ(num_different, arrived.reception.num_bits_flipped);
    num_flipped += num_different;
    p = arrived.reception.bit_error_probability;
  }
  EXPECT_GT(p, 1e-3);
  EXPECT_LT(std::abs(num_flipped - kBits * p), kNormalLimit * std::sqrt(kBits * p * (1 - p)));
}

/// Random traffic of four nodes under these options, by source, number and receiver.
using Link = std::tuple<int, int64_t, int>;
std::map<Link, Arrived> Play(const AcousticOptions& options, uint64_t seed) {
  AcousticNetwork network(options, seed, TestNodes(4));
  TrafficGenerator generator(seed);
  const Positions positions_m = generator.RandomPositions(4, 6000);
  for (int i = 0; i < 20; ++i) {
    network.Transmit(0.3 * i, generator.Int(0, 3), positions_m, generator.RandomBytes(37),
                     AllOf(network));
  }
  std::map<Link, Arrived> by_link;
  for (const Arrived& one : DeliverAll(&network)) {
    by_link[{one.reception.packet.source, one.reception.packet.number, one.reception.receiver}] =
        one;
  }
  return by_link;
}

RC_GTEST_PROP(ModemModels, TakeTheSameDrawsAsAllOthers, (uint64_t seed)) {
  AcousticOptions jittery = Lossy();
  jittery.jitter = JitterModel::kUniform;
  AcousticOptions uniform = jittery;
  uniform.packet_loss_model = PacketLossModel::kUniform;
  uniform.packet_loss = 0.5;
  const auto with_uniform = Play(uniform, seed);
  for (const auto& [link, one] : Play(jittery, seed)) {
    const Reception& other = with_uniform.at(link).reception;
    RC_ASSERT(one.reception.jitter_s == other.jitter_s);
    const bool is_lost = one.reception.fate == AcousticFate::kLost;
    const bool would_be_lost_by_half = other.fate == AcousticFate::kLost;
    // The draw is below the one probability and not below the other.
    if (is_lost && !would_be_lost_by_half) RC_ASSERT(one.reception.loss_probability > 0.5);
    if (!is_lost && would_be_lost_by_half) RC_ASSERT(one.reception.loss_probability < 0.5);
  }
}

RC_GTEST_PROP(ModemModels, LeaveHalfDuplexAlone, (uint64_t seed)) {
  AcousticOptions silent = IdealOptions(AccessMode::kShared);
  silent.half_duplex = true;
  AcousticOptions lossy = Lossy();
  lossy.half_duplex = true;
  const auto with_modem = Play(lossy, seed);
  for (const auto& [link, one] : Play(silent, seed)) {
    const Reception& other = with_modem.at(link).reception;
    RC_ASSERT((one.reception.fate == AcousticFate::kHalfDuplex) ==
              (other.fate == AcousticFate::kHalfDuplex));
    RC_ASSERT(one.reception.own_number == other.own_number);
    RC_ASSERT(one.reception.end_s == other.end_s);
  }
}

}  // namespace shoal::modem_models_test
