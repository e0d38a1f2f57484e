// One transmission on its way over media, from the moment at which the rules let it pass: its
// receivers, and what is needed to deliver it then.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/routing/fate.h"
#include "lib/sea/acoustics/acoustic_network.h"
#include "lib/sea/media/radio_link.h"

namespace shoal {

class AcousticTraffic;

/// The maker of what is sent, and the gateways by which it came: lib/sea/media/relay_path.h.
struct Provenance {
  std::string origin;
  int64_t number = 0;  ///< Of its maker's transmission, of its kind.
  int64_t made_utime = 0;
  std::string via = {};  ///< Empty: its maker sends it.
};

/// By which medium a leg goes, and the numbers that decided.
struct LegMedium {
  std::string_view name = {};  ///< Empty: none. MediaTraffic holds it.
  RadioLink radio = {};
  double loss_probability = -1;
  double delay_s = -1;
};

/// Copies of one transmission that go to one receiver at once over several media: the first that
/// arrives is delivered; where none does, the last decides the fate.
struct Copies {
  int num_left = 0;
  bool is_concluded = false;
};

/// One receiver of a shipment.
struct ShipmentLeg {
  Decision decision;  ///< In transit.
  std::string destination;
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();  ///< Where it was when the packet was sent.
  LegMedium medium = {};
  std::shared_ptr<Copies> copies = nullptr;
  int node = -1;  ///< AcousticTraffic's own.
};

/// One transmission.
struct Shipment {
  Kind kind = Kind::kPacket;
  std::string source;
  int64_t number = 0;                   ///< Of its kind.
  std::vector<uint8_t> message;         ///< As it came to the broker.
  std::vector<uint8_t> payload;         ///< What goes over the air, without a checksum.
  std::optional<double> data_rate_bps;  ///< Its own; absent: the network's.
  std::optional<int> channel = {};      ///< The id that its sender chose; absent: the sender's own.
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
  bool has_pulses = false;
  std::string color;  ///< Of its pulses.
  Provenance provenance;
  std::vector<ShipmentLeg> legs;
};

/// A shipment that has come to the end of one leg.
struct LegEnd {
  const Shipment& shipment;
  const ShipmentLeg& leg;
  Cause cause;                            ///< Its fate, but kDamaged may be kRejected.
  std::span<const uint8_t> payload = {};  ///< What arrived; empty where nothing did.
  int64_t sent_utime = 0;
  int64_t arrived_utime = 0;             ///< Rounded to a microsecond.
  const Reception* reception = nullptr;  ///< Of an acoustic network that it went over.
  AcousticTraffic* acoustic = nullptr;   ///< Likewise.
};

using TakeLegEnd = std::function<void(const LegEnd&)>;

}  // namespace shoal
