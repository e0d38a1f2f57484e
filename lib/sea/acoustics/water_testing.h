// Shared by the tests of the acoustic network: nodes, traffic, and a list of what arrived.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "lib/base/random/stream.h"
#include "lib/sea/acoustics/acoustic_network.h"

namespace shoal {

using Bytes = std::vector<uint8_t>;
using Positions = std::vector<Eigen::Vector3d>;

inline std::vector<AcousticNode> TestNodes(int count) {
  std::vector<AcousticNode> nodes;
  for (int i = 0; i < count; ++i) {
    nodes.push_back({.name = "node_" + std::to_string(i), .address = i + 1, .is_leader = i == 0});
  }
  return nodes;
}

inline std::vector<int> AllOf(const AcousticNetwork& network) {
  std::vector<int> nodes(static_cast<size_t>(network.num_nodes()));
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

/// Returns options under which everything arrives, undamaged and after its travel time.
inline AcousticOptions IdealOptions(AccessMode mode) {
  return {.access_mode = mode,
          .jitter = JitterModel::kOff,
          .collisions = CollisionModel::kOff,
          .packet_loss_model = PacketLossModel::kOff,
          .bit_error_model = BitErrorModel::kOff};
}

/// Returns a modem with a range of about 5 km.
inline ModemPreset TestModem() {
  return {.name = "test",
          .low_khz = 24,
          .high_khz = 32,
          .data_rate_bps = 463,
          .max_packet_bytes = 64,
          .source_level_db = 168,
          .typical_range_m = 2000,
          .modulation = Modulation::kCoherentPsk,
          .fading = Fading::kRayleigh,
          .code = {.block_bits = 127, .data_bits = 92, .corrected_bits = 5},
          .sources = {}};
}

/// A reception with its own copy of the bytes.
struct Arrived {
  Reception reception;
  Bytes bytes;
};

/// Delivers until then and appends what came.
inline void DeliverTo(AcousticNetwork* network, double until_s, std::vector<Arrived>* arrived) {
  for (const Reception& reception : network->Deliver(until_s)) {
    arrived->push_back({reception, {reception.bytes.begin(), reception.bytes.end()}});
  }
}

inline std::vector<Arrived> DeliverAll(AcousticNetwork* network, double until_s = 1e9) {
  std::vector<Arrived> arrived;
  DeliverTo(network, until_s, &arrived);
  return arrived;
}

/// Something that a node sends.
struct Sent {
  double time_s = 0;
  int source = 0;
  Bytes bytes;
  std::vector<int> receivers;
};

/// Draws schedules at random; the same seed, the same schedules.
class TrafficGenerator {
 public:
  explicit TrafficGenerator(uint64_t seed) : stream_(seed, "test traffic") {}

  int Int(int low, int high) {  ///< Both included.
    return low + static_cast<int>(stream_.UniformInt(static_cast<uint64_t>(high - low) + 1));
  }
  double Double(double low, double high) { return low + (high - low) * stream_.Uniform(); }
  bool OneIn(int count) { return Int(1, count) == 1; }

  Bytes RandomBytes(int count) {
    Bytes bytes(static_cast<size_t>(count));
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(stream_.UniformInt(256));
    return bytes;
  }
  Positions RandomPositions(int count, double side_m) {
    Positions positions_m;
    for (int i = 0; i < count; ++i) {
      positions_m.emplace_back(Double(0, side_m), Double(0, side_m), Double(0, 100));
    }
    return positions_m;
  }
  AcousticOptions RandomOptions() {
    AcousticOptions options;
    options.access_mode = static_cast<AccessMode>(Int(0, 3));
    options.channel_order = static_cast<ChannelOrder>(Int(0, 1));
    options.jitter = static_cast<JitterModel>(Int(0, 1));
    options.collisions = static_cast<CollisionModel>(Int(0, 2));
    options.packet_loss_model = static_cast<PacketLossModel>(Int(0, 3));
    options.bit_error_model = static_cast<BitErrorModel>(Int(0, 3));
    options.half_duplex = OneIn(2);
    options.packet_loss = OneIn(4) ? 1 : Double(0, 0.3);
    options.bit_error_rate = OneIn(4) ? 0.5 : Double(0, 0.01);
    if (OneIn(3)) {
      options.modem = TestModem();
      options.packet_loss_model = PacketLossModel::kModem;
    }
    return options;
  }

 private:
  Stream stream_;
};

}  // namespace shoal
