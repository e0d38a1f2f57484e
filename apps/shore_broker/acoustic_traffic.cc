#include "apps/shore_broker/acoustic_traffic.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/codec/crc32.h"
#include "lib/base/codec/little_endian.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/sea/acoustics/validate_options.h"

namespace shoal {

namespace {

/// Between two packets of one modem, so that rounding lets none meet.
constexpr double kBetweenPackets_s = 1e-3;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Why the network cannot be; empty: it can.
std::string ProblemOf(const BrokerSetup& setup, const Acoustics& acoustics,
                      std::span<const AcousticNode> nodes) {
  const std::string missing = setup.MissingOf(acoustics);
  if (!missing.empty()) return missing;
  const auto problems = FindProblems(acoustics.options, {nodes.begin(), nodes.end()});
  return problems.empty() ? "" : problems.front().option + ": " + problems.front().message;
}

/// Some options are impossible without nodes, so that where the mission's do not fit, these take
/// their place too.
AcousticNetwork NetworkOf(const BrokerSetup& setup, const Acoustics& acoustics, uint64_t seed,
                          std::span<const AcousticNode> nodes, bool fits) {
  return fits ? AcousticNetwork(acoustics.options, seed, {nodes.begin(), nodes.end()},
                                setup.SurroundingsOf(acoustics))
              : AcousticNetwork(AcousticOptions(), seed, {});
}

}  // namespace

AcousticTraffic::AcousticTraffic(const BrokerSetup& setup, const Acoustics& acoustics,
                                 uint64_t seed, std::span<const AcousticNode> nodes)
    : crc_(acoustics.crc),
      queues_(acoustics.queue),
      queue_length_(static_cast<size_t>(acoustics.queue_length)),
      queue_drop_(acoustics.queue_drop),
      tick_us_(setup.tick_us),
      epoch_utime_(setup.start_utime),
      max_payload_bytes_(kMaxPayload_bytes),
      problem_(ProblemOf(setup, acoustics, nodes)),
      network_(NetworkOf(setup, acoustics, seed, nodes, problem_.empty())) {
  if (!problem_.empty()) nodes = {};
  for (const AcousticNode& node : nodes) {
    node_of_.emplace(VehicleKey(node.name), static_cast<int>(nodes_.size()));
    nodes_.push_back({.name = node.name,
                      .address = static_cast<uint32_t>(node.address),
                      .modem_depth_m = setup.media.ModemDepth_m(node.name)});
  }
  positions_m_.assign(nodes_.size(), Eigen::Vector3d::Constant(kNaN));
  velocities_mps_.assign(nodes_.size(), Eigen::Vector3d::Zero());
  max_nodes_ = nodes_.size() + Router::kMaxUnregistered;
  if (const auto& modem = acoustics.options.modem) {
    max_payload_bytes_ = std::min(kMaxPayload_bytes, modem->max_packet_bytes);
  }
}

void AcousticTraffic::Place(std::string_view name, const Eigen::Vector3d& position_m,
                            const Eigen::Vector3d& velocity_mps) {
  std::optional<int> node = FindNode(name);
  if (!node) {
    if (!problem_.empty() || nodes_.size() >= max_nodes_) return;
    uint32_t address = 1;
    for (const Node& each : nodes_) address = std::max(address, each.address + 1);
    if (address > static_cast<uint32_t>(std::numeric_limits<int>::max())) return;
    const std::string key = VehicleKey(name);
    const Result<int> index =
        network_.AddNode({.name = key, .address = static_cast<int>(address), .is_leader = false});
    if (!index.ok()) return;
    node = *index;
    node_of_.emplace(key, *node);
    nodes_.push_back({.name = std::string(name), .address = address});
    positions_m_.emplace_back();
    velocities_mps_.emplace_back();
  }
  const double hangs_m = nodes_[static_cast<size_t>(*node)].modem_depth_m;
  positions_m_[static_cast<size_t>(*node)] = position_m + Eigen::Vector3d(0, 0, hangs_m);
  velocities_mps_[static_cast<size_t>(*node)] = velocity_mps;
}

/// The broker receives in one step what was published in the step before. Live, steps are as short
/// as the traffic permits, and nothing is sent before what has been delivered already.
int64_t AcousticTraffic::SentUtime(int64_t utime) const {
  const int64_t published_utime = utime - tick_us_;
  return delivered_utime_ ? std::max(published_utime, *delivered_utime_) : published_utime;
}

std::vector<AcousticTraffic::Refusal> AcousticTraffic::Send(int64_t utime, Shipment shipment) {
  std::vector<Refusal> refusals;
  const auto refuse_if = [&](Cause cause, const auto& is_refused) {
    for (ShipmentLeg& leg : shipment.legs) {
      if (is_refused(leg)) refusals.push_back({.leg = std::move(leg), .cause = cause});
    }
  };
  const std::optional<int> source = FindNode(shipment.source);
  const std::pair<size_t, int64_t> lengths[] = {{shipment.payload.size(), max_payload_bytes_},
                                                {shipment.message.size(), kMaxMessage_bytes}};
  for (const auto& [size, limit_bytes] : lengths) {
    const auto length_bytes = static_cast<int64_t>(size);
    if (length_bytes <= limit_bytes) continue;
    for (ShipmentLeg& leg : shipment.legs) {
      leg.decision.length_bytes = length_bytes;
      leg.decision.length_limit_bytes = limit_bytes;
    }
    refuse_if(Cause::kTooLong, [](const ShipmentLeg&) { return true; });
    return refusals;
  }
  std::optional<int> channel;
  if (shipment.channel) channel = ChannelWith(*shipment.channel);
  const bool has_channel = !shipment.channel || channel;
  if (!source || !has_channel ||
      nodes_[static_cast<size_t>(*source)].num_packets >= kMaxPacketsOfOne) {
    refuse_if(Cause::kNoChannel, [](const ShipmentLeg&) { return true; });
    return refusals;
  }
  for (ShipmentLeg& leg : shipment.legs) leg.node = FindNode(leg.destination).value_or(-1);
  refuse_if(Cause::kNoChannel, [](const ShipmentLeg& leg) { return leg.node < 0; });
  std::erase_if(shipment.legs, [](const ShipmentLeg& leg) { return leg.node < 0; });
  std::sort(shipment.legs.begin(), shipment.legs.end(),
            [](const ShipmentLeg& a, const ShipmentLeg& b) { return a.node < b.node; });

  Node& node = nodes_[static_cast<size_t>(*source)];
  const double sent_s = SecondsOf(SentUtime(utime));
  LaunchWaiting(sent_s);  // Live, steps are longer than a tick: others were due before.
  if (!queues_ || (node.waiting.empty() && node.free_s <= sent_s)) {
    Launch(sent_s, *source, std::move(shipment));
    return refusals;
  }
  num_waiting_legs_ += static_cast<int64_t>(shipment.legs.size());
  // Of one vehicle's reports only the newest waits, at the place of the one before, unless a
  // receiver of that one would get neither.
  const auto older = std::ranges::find_if(node.waiting, [&](const Shipment& each) {
    return shipment.kind == Kind::kReport && each.kind == Kind::kReport &&
           each.channel == shipment.channel &&
           each.provenance.origin == shipment.provenance.origin &&
           each.provenance.number < shipment.provenance.number &&
           std::ranges::includes(shipment.legs, each.legs, {}, &ShipmentLeg::node,
                                 &ShipmentLeg::node);
  });
  if (older != node.waiting.end()) {
    thrown_away_.push_back(std::exchange(*older, std::move(shipment)));
    return refusals;
  }
  if (node.waiting.size() >= queue_length_) {
    if (queue_drop_ == Acoustics::QueueDrop::kNewest) {
      num_waiting_legs_ -= static_cast<int64_t>(shipment.legs.size());
      refuse_if(Cause::kQueueFull, [](const ShipmentLeg&) { return true; });
      return refusals;
    }
    thrown_away_.push_back(std::move(node.waiting.front()));
    node.waiting.pop_front();
  }
  node.waiting.push_back(std::move(shipment));
  return refusals;
}

void AcousticTraffic::Launch(double time_s, int source, Shipment shipment) {
  Node& node = nodes_[static_cast<size_t>(source)];
  std::optional<int> channel;
  if (shipment.channel) channel = ChannelWith(*shipment.channel);
  std::vector<int> receivers;
  for (ShipmentLeg& leg : shipment.legs) {
    leg.to_m = positions_m_[static_cast<size_t>(leg.node)];
    receivers.push_back(leg.node);
  }
  shipment.from_m = positions_m_[static_cast<size_t>(source)];
  std::vector<uint8_t> frame = shipment.payload;
  if (crc_) AppendLittleEndian(Crc32(shipment.payload), &frame);
  const int64_t number = network_.Transmit(time_s, source, positions_m_, frame, receivers,
                                           {.data_rate_bps = shipment.data_rate_bps,
                                            .channel = channel,
                                            .velocities_mps = velocities_mps_});
  const AcousticOptions& options = network_.options();
  const double air_s = 8 * static_cast<double>(frame.size()) /
                       shipment.data_rate_bps.value_or(options.data_rate_bps);
  const double jitter_s = options.jitter == JitterModel::kOff ? 0 : options.max_jitter_s;
  node.free_s = std::max(node.free_s, time_s + air_s + jitter_s + kBetweenPackets_s);
  if (receivers.empty()) return;
  ++node.num_packets;
  const size_t num_legs = receivers.size();
  under_way_.emplace(PacketId{.source = source, .number = number},
                     UnderWay{.shipment = std::move(shipment),
                              .sent_utime = UtimeOf(time_s),
                              .num_legs_left = num_legs});
}

std::optional<int> AcousticTraffic::NextToLaunch() const {
  std::optional<int> next;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].waiting.empty()) continue;
    if (next && nodes_[i].free_s >= nodes_[static_cast<size_t>(*next)].free_s) continue;
    next = static_cast<int>(i);
  }
  return next;
}

void AcousticTraffic::LaunchWaiting(double until_s) {
  while (const std::optional<int> next = NextToLaunch()) {
    Node& node = nodes_[static_cast<size_t>(*next)];
    if (node.free_s > until_s) return;
    Shipment shipment = std::move(node.waiting.front());
    node.waiting.pop_front();
    num_waiting_legs_ -= static_cast<int64_t>(shipment.legs.size());
    Launch(node.free_s, *next, std::move(shipment));
  }
}

void AcousticTraffic::Deliver(int64_t utime, const TakeLegEnd& take) {
  delivered_utime_ = delivered_utime_ ? std::max(utime, *delivered_utime_) : utime;
  for (const Shipment& shipment : std::exchange(thrown_away_, {})) {
    num_waiting_legs_ -= static_cast<int64_t>(shipment.legs.size());
    for (const ShipmentLeg& leg : shipment.legs) {
      take({.shipment = shipment,
            .leg = leg,
            .cause = Cause::kQueueFull,
            .sent_utime = *delivered_utime_,
            .arrived_utime = *delivered_utime_});
    }
  }
  LaunchWaiting(SecondsOf(*delivered_utime_));
  for (const Reception& reception : network_.Deliver(SecondsOf(*delivered_utime_))) {
    const auto found = under_way_.find(reception.packet);
    SHOAL_CHECK(found != under_way_.end(), "what arrives was sent");
    UnderWay& under_way = found->second;
    const std::vector<ShipmentLeg>& legs = under_way.shipment.legs;
    const auto leg = std::lower_bound(
        legs.begin(), legs.end(), reception.receiver,
        [](const ShipmentLeg& each, int32_t receiver) { return each.node < receiver; });
    SHOAL_CHECK(leg != legs.end() && leg->node == reception.receiver,
                "what arrives was addressed to its receiver");
    std::span<const uint8_t> payload;
    if (HandsOver(reception.fate))
      payload = reception.bytes.first(under_way.shipment.payload.size());
    take({.shipment = under_way.shipment,
          .leg = *leg,
          .cause = CauseOf(reception, under_way.shipment),
          .payload = payload,
          .sent_utime = under_way.sent_utime,
          .arrived_utime = UtimeOf(reception.end_s),
          .reception = &reception,
          .acoustic = this});
    if (--under_way.num_legs_left > 0) continue;
    --nodes_[static_cast<size_t>(reception.packet.source)].num_packets;
    under_way_.erase(found);
  }
}

std::optional<int64_t> AcousticTraffic::NextUtime() const {
  if (num_in_transit() == 0) return std::nullopt;
  double next_s = network_.NextEvent_s();
  if (const std::optional<int> next = NextToLaunch()) {
    next_s = std::min(next_s, nodes_[static_cast<size_t>(*next)].free_s);
  }
  if (!thrown_away_.empty()) return delivered_utime_.value_or(epoch_utime_);
  // A microsecond earlier: this is rounded, and the network's times are too.
  return UtimeOf(next_s) - 1;
}

Cause AcousticTraffic::CauseOf(const Reception& reception, const Shipment& shipment) const {
  switch (reception.fate) {
    case AcousticFate::kNotListening:
      return Cause::kNotListening;
    case AcousticFate::kNoPath:
      return Cause::kNoPath;
    case AcousticFate::kShadowZone:
      return Cause::kShadowZone;
    case AcousticFate::kHalfDuplex:
      return Cause::kHalfDuplex;
    case AcousticFate::kCollided:
      return Cause::kCollision;
    case AcousticFate::kLost:
      return Cause::kPacketLoss;
    case AcousticFate::kDelivered:
      return Cause::kDelivered;
    case AcousticFate::kDamagedByCollision:
    case AcousticFate::kDamagedByBitErrors:
      break;
  }
  const std::span<const uint8_t> payload = reception.bytes.first(shipment.payload.size());
  if (!crc_) {
    // Two errors can undo each other, and bits flip where a collision had flipped them before.
    return std::ranges::equal(payload, shipment.payload) ? Cause::kDelivered : Cause::kDamaged;
  }
  LittleEndianReader checksum(reception.bytes.subspan(shipment.payload.size()));
  if (checksum.Take<uint32_t>() == Crc32(payload)) {
    return std::ranges::equal(payload, shipment.payload) ? Cause::kDelivered : Cause::kDamaged;
  }
  return reception.fate == AcousticFate::kDamagedByCollision ? Cause::kCollision
                                                             : Cause::kBitErrors;
}

std::optional<int> AcousticTraffic::FindNode(std::string_view name) const {
  const auto found = node_of_.find(VehicleKey(name));
  if (found == node_of_.end()) return std::nullopt;
  return found->second;
}

std::optional<uint32_t> AcousticTraffic::AddressOf(std::string_view name) const {
  const std::optional<int> node = FindNode(name);
  if (!node) return std::nullopt;
  return nodes_[static_cast<size_t>(*node)].address;
}

std::optional<int> AcousticTraffic::ChannelWith(int id) const {
  const std::span<const AcousticChannel> channels = network_.plan().channels();
  const auto found = std::ranges::find(channels, id, &AcousticChannel::id);
  if (found == channels.end()) return std::nullopt;
  return static_cast<int>(found - channels.begin());
}

std::string_view AcousticTraffic::VehicleAt(uint32_t address) const {
  for (const Node& node : nodes_) {
    if (node.address == address) return node.name;
  }
  return {};
}

std::string AcousticTraffic::NameOf(const PacketId& packet) const {
  return fmt::format("{} {}", nodes_[static_cast<size_t>(packet.source)].name, packet.number);
}

}  // namespace shoal
