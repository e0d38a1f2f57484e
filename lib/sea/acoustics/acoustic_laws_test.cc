// Random effects against their law. Each test is wrong about a right program once in a million
// seeds, and the seed is fixed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "lib/sea/acoustics/loss_models.h"
#include "lib/sea/acoustics/water_testing.h"

namespace shoal::acoustic_laws_test {

/// A normal variate is farther from 0 than this once in a million times.
constexpr double kNormalLimit = 4.89;

/// Returns what chi-square with `degrees` of freedom exceeds once in a million times (Wilson and
/// Hilferty, 1931).
double ChiSquareLimit(double degrees) {
  const double variance = 2 / (9 * degrees);
  return degrees * std::pow(1 - variance + 4.7534 * std::sqrt(variance), 3);
}

/// The test of Kolmogorov and Smirnov; the limit is that of large samples.
void ExpectLaw(std::vector<double> sample, const std::function<double(double)>& distribution) {
  std::ranges::sort(sample);
  const auto n = static_cast<double>(sample.size());
  double distance = 0;
  for (size_t i = 0; i < sample.size(); ++i) {
    const double expected = distribution(sample[i]);
    const auto rank = static_cast<double>(i);
    distance = std::max({distance, expected - rank / n, (rank + 1) / n - expected});
  }
  EXPECT_LT(distance, std::sqrt(std::log(2e6) / (2 * n)));
}

/// Sends `count` packets, one a second, from node 0 to node 1 at this range.
std::vector<Arrived> SendMany(const AcousticOptions& options, double range_m, int count,
                              int num_bytes) {
  AcousticNetwork network(options, 20261121, TestNodes(2));
  const Positions positions_m = {{0, 0, 0}, {range_m, 0, 0}};
  const Bytes bytes(static_cast<size_t>(num_bytes));
  const std::vector<int> receivers = {1};
  std::vector<Arrived> arrived;
  for (int i = 0; i < count; ++i) {
    network.Transmit(i, 0, positions_m, bytes, receivers);
    if (i % 1000 == 0) DeliverTo(&network, i, &arrived);
  }
  DeliverTo(&network, count + 1e3, &arrived);
  return arrived;
}

TEST(Jitter, IsUniformUpToItsMaximum) {
  AcousticOptions options = IdealOptions(AccessMode::kFdma);
  options.jitter = JitterModel::kUniform;
  options.max_jitter_s = 0.3;
  std::vector<double> jitter_s;
  for (const Arrived& arrived : SendMany(options, 500, 20'000, 1)) {
    jitter_s.push_back(arrived.reception.jitter_s);
    EXPECT_NEAR(arrived.reception.end_s - arrived.reception.sent_s,
                0.008 + 500 / 1500.0 + jitter_s.back(), 1e-9);
  }
  ExpectLaw(jitter_s, [](double x_s) { return std::clamp(x_s / 0.3, 0.0, 1.0); });
}

TEST(InterArrivalTimes, SpreadLikeTheDifferenceOfTwoJitters) {
  AcousticOptions options = IdealOptions(AccessMode::kFdma);
  options.jitter = JitterModel::kUniform;
  const std::vector<Arrived> arrived = SendMany(options, 500, 20'000, 1);
  std::vector<double> difference;  // Of pairs that share no packet, in units of the maximum.
  for (size_t i = 0; i + 1 < arrived.size(); i += 2) {
    const double gap_s = arrived[i + 1].reception.end_s - arrived[i].reception.end_s;
    difference.push_back((gap_s - 1) / options.max_jitter_s);
  }
  ExpectLaw(difference, [](double x) {
    const double tail = std::max(0.0, 1 - std::abs(x));
    return x < 0 ? tail * tail / 2 : 1 - tail * tail / 2;
  });
}

TEST(PacketLoss, StrikesAsOftenAsItsProbability) {
  constexpr int kPackets = 10'000;
  for (const PacketLossModel model :
       {PacketLossModel::kUniform, PacketLossModel::kExpSimple, PacketLossModel::kSonarSimple}) {
    for (const double range_m : {200.0, 1000.0, 3000.0}) {
      AcousticOptions options = IdealOptions(AccessMode::kShared);
      options.packet_loss_model = model;
      options.packet_loss = 0.05;
      int num_lost = 0;
      for (const Arrived& arrived : SendMany(options, range_m, kPackets, 1)) {
        num_lost += arrived.reception.fate == AcousticFate::kLost ? 1 : 0;
      }
      const double p = PacketLossProbability(options, range_m, options.base_freq_khz);
      const double deviation = std::sqrt(kPackets * p * (1 - p));
      EXPECT_LT(std::abs(num_lost - kPackets * p), kNormalLimit * deviation)
          << ChoiceText(model) << " at " << range_m << " m: " << num_lost;
    }
  }
}

/// Returns the probability of k wrong bits of n.
double BinomialMass(int n, int k, double p) {
  return std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) +
                  k * std::log(p) + (n - k) * std::log1p(-p));
}

TEST(BitErrors, AreBinomialInNumber) {
  constexpr int kPackets = 5000;
  constexpr int kBytes = 37;
  for (const double rate : {0.001, 0.01, 0.5}) {
    AcousticOptions options = IdealOptions(AccessMode::kFdma);
    options.bit_error_model = BitErrorModel::kPoisson;
    options.bit_error_rate = rate;
    std::vector<double> counts(8 * kBytes + 1, 0);
    for (const Arrived& arrived : SendMany(options, 500, kPackets, kBytes)) {
      ++counts[static_cast<size_t>(arrived.reception.num_bits_flipped)];
    }
    double chi_square = 0;
    double degrees = -1;
    double rest_observed = 0;  // Of numbers too rare to stand alone.
    double rest_expected = 0;
    for (int k = 0; k <= 8 * kBytes; ++k) {
      rest_observed += counts[static_cast<size_t>(k)];
      rest_expected += kPackets * BinomialMass(8 * kBytes, k, rate);
      if (rest_expected < 10) continue;
      chi_square +=
          (rest_observed - rest_expected) * (rest_observed - rest_expected) / rest_expected;
      degrees += 1;
      rest_observed = rest_expected = 0;
    }
    EXPECT_GE(degrees, 2);
    EXPECT_LT(chi_square, ChiSquareLimit(degrees)) << rate;
  }
}

TEST(BitErrors, StrikeEveryBitEquallyOften) {
  constexpr int kPackets = 20'000;
  constexpr int kBytes = 4;
  AcousticOptions options = IdealOptions(AccessMode::kFdma);
  options.bit_error_model = BitErrorModel::kPoisson;
  options.bit_error_rate = 0.05;
  std::vector<double> counts(8 * kBytes, 0);
  for (const Arrived& arrived : SendMany(options, 500, kPackets, kBytes)) {
    for (size_t bit = 0; bit < counts.size(); ++bit) {
      counts[bit] += arrived.bytes[bit / 8] >> (bit % 8) & 1;
    }
  }
  double chi_square = 0;
  for (const double count : counts) {
    const double expected = kPackets * options.bit_error_rate;
    chi_square += (count - expected) * (count - expected) / (expected * (1 - 0.05));
  }
  EXPECT_LT(chi_square, ChiSquareLimit(8 * kBytes));
}

/// Sends `count` packets from node 0 to all of four nodes; returns the jitters of each receiver.
std::vector<std::vector<double>> JittersOfReceivers(int count) {
  AcousticOptions options = IdealOptions(AccessMode::kFdma);
  options.jitter = JitterModel::kUniform;
  options.max_jitter_s = 1;
  AcousticNetwork network(options, 20261121, TestNodes(4));
  const Positions one_place(4, Eigen::Vector3d::Zero());
  const std::vector<int> all = AllOf(network);
  std::vector<std::vector<double>> jitters(4);
  for (int i = 0; i < count; ++i) network.Transmit(2 * i, 0, one_place, {}, all);
  for (const Arrived& arrived : DeliverAll(&network)) {
    jitters[static_cast<size_t>(arrived.reception.receiver)].push_back(arrived.reception.jitter_s);
  }
  return jitters;
}

TEST(Receivers, OfOnePacketDrawIndependently) {
  constexpr int kPackets = 5000;
  const std::vector<std::vector<double>> jitters = JittersOfReceivers(kPackets);
  for (size_t a = 1; a < 4; ++a) {
    for (size_t b = a + 1; b < 4; ++b) {
      double covariance = 0;  // Each packet adds a term of variance 1/144.
      for (size_t i = 0; i < kPackets; ++i) {
        covariance += (jitters[a][i] - 0.5) * (jitters[b][i] - 0.5);
      }
      EXPECT_LT(std::abs(covariance), kNormalLimit * std::sqrt(kPackets) / 12);
    }
  }
}

TEST(JitterAndLoss, HaveNothingToDoWithEachOther) {
  AcousticOptions options = IdealOptions(AccessMode::kFdma);
  options.jitter = JitterModel::kUniform;
  options.packet_loss_model = PacketLossModel::kUniform;
  options.packet_loss = 0.5;
  std::vector<double> jitter_of_lost;
  for (const Arrived& arrived : SendMany(options, 500, 20'000, 1)) {
    if (arrived.reception.fate == AcousticFate::kLost) {
      jitter_of_lost.push_back(arrived.reception.jitter_s / options.max_jitter_s);
    }
  }
  ExpectLaw(jitter_of_lost, [](double x) { return x; });
}

}  // namespace shoal::acoustic_laws_test
