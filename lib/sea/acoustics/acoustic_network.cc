#include "lib/sea/acoustics/acoustic_network.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/sea/acoustics/bit_errors.h"

namespace shoal {

namespace {

ChannelPlan PlanOrDie(const AcousticOptions& options, std::span<const AcousticNode> nodes) {
  Result<ChannelPlan> plan = ChannelPlan::Make(options, nodes);
  SHOAL_CHECK(plan.ok(), "FindProblems(options, nodes) is empty");
  return std::move(*plan);
}

}  // namespace

AcousticNetwork::AcousticNetwork(const AcousticOptions& options, uint64_t seed,
                                 std::span<const AcousticNode> nodes,
                                 const RaySurroundings& surroundings)
    : options_(options),
      plan_(PlanOrDie(options, nodes)),
      path_(options),
      seed_(seed),
      now_s_(-std::numeric_limits<double>::infinity()) {
  SHOAL_CHECK(nodes.size() <= kMaxAcousticNodes, "at most kMaxAcousticNodes nodes");
  if (options.rays) rays_.emplace(*options.rays, surroundings, path_.band());
  for (const AcousticNode& node : nodes) {
    SHOAL_CHECK(names_.insert(node.name).second, "node names are unique");
    nodes_.emplace_back(node.name, seed_);
  }
}

Result<int> AcousticNetwork::AddNode(const AcousticNode& node) {
  if (names_.contains(node.name)) {
    return Error{"'" + node.name + "' is in the acoustic network already; names are unique"};
  }
  if (num_nodes() == kMaxAcousticNodes) return Error{"the acoustic network has no more room"};
  Result<int> index = plan_.Add(node);
  if (!index.ok()) return index;
  names_.insert(node.name);
  nodes_.emplace_back(node.name, seed_);
  return index;
}

int64_t AcousticNetwork::Transmit(double time_s, int source,
                                  std::span<const Eigen::Vector3d> positions_m,
                                  std::span<const uint8_t> bytes, std::span<const int> receivers,
                                  const PacketOptions& options) {
  SHOAL_CHECK(std::isfinite(time_s) && time_s >= now_s_,
              "time_s is finite and not before an earlier call");
  SHOAL_CHECK(source >= 0 && source < num_nodes(), "source is the index of a node");
  SHOAL_CHECK(positions_m.size() == nodes_.size(), "each node has a position");
  SHOAL_CHECK(options.velocities_mps.empty() || options.velocities_mps.size() == nodes_.size(),
              "each node has a velocity, or none");
  const std::optional<double> data_rate_bps = options.data_rate_bps;
  SHOAL_CHECK(!data_rate_bps || *data_rate_bps > 0, "data_rate_bps > 0");
  const int channel = options.channel.value_or(plan_.SendsOn(source));
  SHOAL_CHECK(channel >= 0 && channel < static_cast<int>(plan_.channels().size()),
              "the plan has the channel");
  now_s_ = time_s;
  Recycle();

  Node& sender = nodes_[static_cast<size_t>(source)];
  const int32_t index = transmissions_.Take(bytes);
  AcousticTransmission& transmission = transmissions_[index];
  transmission.packet = {source, sender.num_sent++};
  transmission.key = sender.sends.With(transmission.packet.number);
  transmission.turn = statistics_.num_transmissions++;
  transmission.sent_s = time_s;
  transmission.data_rate_bps = data_rate_bps;
  transmission.air_s =
      8 * static_cast<double>(bytes.size()) / data_rate_bps.value_or(options_.data_rate_bps);
  transmission.channel = channel;
  transmission.num_users = 1;  // This call: the bytes outlive it.
  if (options_.half_duplex && !bytes.empty()) {
    ++transmission.num_users;
    events_.Push(MakeEvent(AcousticEventKind::kTransmissionStarts, time_s, transmission.turn,
                           source, index));
  }
  for (const int receiver : receivers) {
    SHOAL_CHECK(receiver >= 0 && receiver < num_nodes(), "receivers are indices of nodes");
    int64_t* last_offered = &nodes_[static_cast<size_t>(receiver)].last_offered;
    if (receiver == source || *last_offered == transmission.turn) continue;
    *last_offered = transmission.turn;
    ++transmission.num_users;
    Offer(transmission, index, receiver, positions_m, options.velocities_mps);
  }
  transmissions_.Release(index);
  return transmission.packet.number;
}

void AcousticNetwork::Offer(const AcousticTransmission& transmission, int32_t index, int receiver,
                            std::span<const Eigen::Vector3d> positions_m,
                            std::span<const Eigen::Vector3d> velocities_mps) {
  const int32_t slot = receptions_.Take();
  Pending& pending = receptions_[slot];
  pending = {};
  pending.start_s = transmission.sent_s;
  pending.receiver = receiver;
  pending.transmission = index;
  ++statistics_.num_offered;
  const auto end_of = [&](int node) {
    const auto place = static_cast<size_t>(node);
    return RayEnd{.position_m = positions_m[place],
                  .velocity_mps = velocities_mps.empty() ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                                                         : velocities_mps[place]};
  };
  const RayEnd from = end_of(transmission.packet.source);
  const RayEnd to = end_of(receiver);
  const double range_m = (to.position_m - from.position_m).norm();
  if (!plan_.ReceivesOn(receiver, transmission.channel)) {
    pending.fate = AcousticFate::kNotListening;
  } else if (!(range_m <= kMaxRange_m)) {
    pending.fate = AcousticFate::kNoPath;
  } else {
    pending.range_m = range_m;
    FindPath(transmission, from, to, &pending);
  }
  // Whole durations are added to the start, so that nothing arrives before it was sent.
  pending.end_s = pending.start_s + transmission.air_s;
  const bool others_matter = options_.half_duplex || options_.collisions != CollisionModel::kOff;
  const bool starts = others_matter && !pending.fate && pending.start_s < pending.end_s;
  events_.Push(starts ? MakeEvent(AcousticEventKind::kReceptionStarts, pending.start_s,
                                  transmission.turn, receiver, slot)
                      : MakeEvent(AcousticEventKind::kReceptionEnds, pending.end_s,
                                  transmission.turn, receiver, slot));
}

void AcousticNetwork::FindPath(const AcousticTransmission& transmission, const RayEnd& from,
                               const RayEnd& to, Pending* pending) {
  pending->travel_s = pending->range_m / options_.sound_speed_mps;
  if (rays_) {
    pending->rays = rays_->Receive(from, to);
    if (pending->rays->num_arrivals == 0) {
      pending->fate = AcousticFate::kShadowZone;
      pending->start_s = transmission.sent_s + std::exchange(pending->travel_s, -1);
      return;
    }
    pending->travel_s = pending->rays->travel_s;
  }
  pending->path = path_.Draw(pending->range_m, plan_.channel(transmission.channel).freq_khz,
                             transmission.bytes.size(), KeyOf(transmission, pending->receiver),
                             transmission.data_rate_bps, pending->rays ? &*pending->rays : nullptr);
  pending->start_s = transmission.sent_s + (pending->travel_s + pending->path.jitter_s);
}

std::span<const Reception> AcousticNetwork::Deliver(double until_s) {
  SHOAL_CHECK(until_s >= now_s_, "until_s is not before an earlier call");
  now_s_ = until_s;
  Recycle();
  while (events_.HasEventUntil(until_s)) {
    const AcousticEvent event = events_.First();
    if (event.kind() == AcousticEventKind::kReceptionStarts) {
      StartReception(event.slot);
      events_.ReplaceFirst(EndOf(event, receptions_[event.slot].end_s));
      continue;
    }
    events_.PopFirst();
    if (event.kind() == AcousticEventKind::kReceptionEnds) {
      EndReception(event.slot);
    } else {
      StartTransmission(event.slot);
    }
  }
  return results_;
}

double AcousticNetwork::NextEvent_s() const {
  return events_.IsEmpty() ? std::numeric_limits<double>::infinity()
                           : TimeOf(events_.First().time_order);
}

AcousticStatistics AcousticNetwork::statistics() const {
  AcousticStatistics statistics = statistics_;
  statistics.num_in_transit = num_in_transit();
  return statistics;
}

void AcousticNetwork::Recycle() {
  results_.clear();
  num_damaged_ = 0;
  transmissions_.Recycle();
}

void AcousticNetwork::StartTransmission(int32_t index) {
  const AcousticTransmission& transmission = transmissions_[index];
  const PacketId& packet = transmission.packet;
  const double end_s = transmission.sent_s + transmission.air_s;
  Node& node = nodes_[static_cast<size_t>(packet.source)];
  ++node.num_started;
  node.last_started = packet.number;
  if (node.longest_number < 0 || end_s > node.sends_until_s) {
    node.sends_until_s = end_s;
    node.longest_number = packet.number;
  }
  transmissions_.Release(index);
}

void AcousticNetwork::StartReception(int32_t slot) {
  Pending& pending = receptions_[slot];
  const Node& receiver = nodes_[static_cast<size_t>(pending.receiver)];
  const bool is_sending = receiver.num_started > 0 && receiver.sends_until_s > pending.start_s;
  pending.own_number = is_sending ? receiver.longest_number : -1;
  pending.num_own_started = receiver.num_started;
  if (options_.collisions == CollisionModel::kOff) return;
  AcousticTransmission& transmission = transmissions_[pending.transmission];
  ++transmission.num_users;  // The lane.
  pending.lane = lanes_.FindOrOpen(pending.receiver, transmission.channel, receptions_.num_used());
  pending.ticket =
      lanes_[pending.lane].Start({pending.start_s, pending.end_s, pending.transmission});
}

void AcousticNetwork::EndReception(int32_t slot) {
  const Pending& pending = receptions_[slot];
  const AcousticTransmission& transmission = transmissions_[pending.transmission];
  Reception& reception = results_.emplace_back();
  reception.packet = transmission.packet;
  reception.receiver = pending.receiver;
  reception.channel = transmission.channel;
  reception.sent_s = transmission.sent_s;
  reception.start_s = pending.start_s;
  reception.end_s = pending.end_s;
  reception.air_s = transmission.air_s;
  reception.range_m = pending.range_m;
  reception.jitter_s = pending.path.jitter_s;
  reception.snr_db = pending.path.snr_db;
  reception.loss_probability = pending.path.loss_probability;
  reception.bit_error_probability = pending.path.bit_error_probability;
  reception.travel_s = pending.travel_s;
  reception.rays = pending.rays;
  if (pending.lane >= 0) {
    reception.num_colliders = lanes_[pending.lane].NumOverlapping(pending.ticket);
    if (reception.num_colliders > 0) {
      ++statistics_.num_collided;
      NameColliders(pending, &reception);
    }
  }
  reception.fate = Decide(pending, &reception);
  ++statistics_.num_fates[static_cast<size_t>(reception.fate)];
  statistics_.num_bits_flipped += reception.num_bits_flipped;
  statistics_.num_bit_errors += reception.num_bits_flipped > 0 ? 1 : 0;
  if (pending.lane >= 0) LeaveLane(pending);
  transmissions_.Release(pending.transmission);
  receptions_.Free(slot);
}

AcousticFate AcousticNetwork::Decide(const Pending& pending, Reception* reception) {
  if (pending.fate) return *pending.fate;
  reception->own_number = OwnNumber(pending);
  if (reception->own_number >= 0) return AcousticFate::kHalfDuplex;
  const bool has_collided = reception->num_colliders > 0;
  if (has_collided && options_.collisions == CollisionModel::kDrop) return AcousticFate::kCollided;
  if (pending.path.is_in_shadow) return AcousticFate::kShadowZone;
  if (pending.path.is_lost) return AcousticFate::kLost;
  return HandOver(pending, reception);
}

/// Returns the number of a packet that the receiver was sending meanwhile, or -1.
int64_t AcousticNetwork::OwnNumber(const Pending& pending) const {
  if (!options_.half_duplex || !(pending.start_s < pending.end_s)) return -1;
  if (pending.own_number >= 0) return pending.own_number;
  const Node& receiver = nodes_[static_cast<size_t>(pending.receiver)];
  return receiver.num_started > pending.num_own_started ? receiver.last_started : -1;
}

void AcousticNetwork::NameColliders(const Pending& pending, Reception* reception) const {
  size_t count = 0;
  lanes_[pending.lane].ForOverlapping(
      pending.ticket, kMaxNamedColliders, [&](const AirLane::Packet& other) {
        reception->colliders[count++] = transmissions_[other.transmission].packet;
      });
  std::sort(reception->colliders.begin(),
            reception->colliders.begin() + static_cast<std::ptrdiff_t>(count));
}

/// Sets the bytes that the receiver gets.
AcousticFate AcousticNetwork::HandOver(const Pending& pending, Reception* reception) {
  const AcousticTransmission& transmission = transmissions_[pending.transmission];
  const std::span<const uint8_t> sent = transmission.bytes;
  reception->bytes = sent;
  if (reception->num_colliders == 0 && pending.path.num_wrong_bits == 0) {
    return AcousticFate::kDelivered;
  }
  const std::span<uint8_t> received = CopyToDamage(sent);
  reception->bytes = received;
  if (reception->num_colliders > 0) XorColliders(pending, received);
  const bool has_changed = reception->num_colliders > 0 && !std::ranges::equal(received, sent);
  reception->num_bits_flipped = pending.path.num_wrong_bits;
  if (pending.path.num_wrong_bits > 0) {
    Stream stream(KeyOf(transmission, pending.receiver).With("wrong bits"));
    FlipRandomBits(pending.path.num_wrong_bits, &stream, received, &scratch_);
  }
  if (has_changed) return AcousticFate::kDamagedByCollision;
  return pending.path.num_wrong_bits > 0 ? AcousticFate::kDamagedByBitErrors
                                         : AcousticFate::kDelivered;
}

void AcousticNetwork::XorColliders(const Pending& pending, std::span<uint8_t> received) const {
  const auto bytes_per_s = [this](int32_t index) {
    return transmissions_[index].data_rate_bps.value_or(options_.data_rate_bps) / 8;
  };
  const Arrival arrival = {pending.start_s, pending.end_s,
                           transmissions_[pending.transmission].bytes};
  const double own_bytes_per_s = bytes_per_s(pending.transmission);
  const AirLane& lane = lanes_[pending.lane];
  lane.ForOverlapping(
      pending.ticket, lane.NumOverlapping(pending.ticket), [&](const AirLane::Packet& other) {
        const Arrival their = {other.start_s, other.end_s,
                               transmissions_[other.transmission].bytes};
        const double their_bytes_per_s = bytes_per_s(other.transmission);
        if (their_bytes_per_s == own_bytes_per_s) {
          XorOverlap(arrival, their, own_bytes_per_s, received);
        } else {
          XorOverlapOfRates(arrival, own_bytes_per_s, their, their_bytes_per_s, received);
        }
      });
}

std::span<uint8_t> AcousticNetwork::CopyToDamage(std::span<const uint8_t> bytes) {
  if (num_damaged_ == damaged_.size()) damaged_.emplace_back();
  std::vector<uint8_t>& copy = damaged_[num_damaged_++];
  copy.assign(bytes.begin(), bytes.end());
  return copy;
}

void AcousticNetwork::LeaveLane(const Pending& pending) {
  unneeded_.clear();
  lanes_[pending.lane].End(pending.ticket, &unneeded_);
  for (const int32_t transmission : unneeded_) transmissions_.Release(transmission);
}

}  // namespace shoal
