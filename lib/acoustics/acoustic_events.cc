// The part of AcousticNetwork in which things start and end.
#include <algorithm>
#include <cstddef>

#include "lib/acoustics/acoustic_network.h"
#include "lib/acoustics/bit_errors.h"

namespace shoal {

namespace {

/// So many idle lanes are kept at least, before it is worth while to look for them.
constexpr size_t kMinIdleLanes = 1024;

}  // namespace

void AcousticNetwork::StartTransmission(int32_t index) {
  const Transmission& transmission = TransmissionOf(index);
  const PacketId& packet = transmission.packet;
  const double end_s = transmission.sent_s + transmission.air_s;
  Node& node = nodes_[static_cast<size_t>(packet.source)];
  ++node.num_started;
  node.last_started = packet.number;
  if (node.longest_number < 0 || end_s > node.sends_until_s) {
    node.sends_until_s = end_s;
    node.longest_number = packet.number;
  }
  Release(index);
}

void AcousticNetwork::StartReception(int32_t slot) {
  Pending& pending = receptions_[static_cast<size_t>(slot)];
  const Node& receiver = nodes_[static_cast<size_t>(pending.receiver)];
  const bool is_sending = receiver.num_started > 0 && receiver.sends_until_s > pending.start_s;
  pending.own_number = is_sending ? receiver.longest_number : -1;
  pending.num_own_started = receiver.num_started;
  if (options_.collisions == CollisionModel::kOff) return;
  Transmission& transmission = transmissions_[static_cast<size_t>(pending.transmission)];
  ++transmission.num_users;  // The lane.
  pending.lane = FindOrOpenLane(pending.receiver, transmission.channel);
  pending.ticket = lanes_[static_cast<size_t>(pending.lane)].Start(
      {pending.start_s, pending.end_s, pending.transmission});
}

void AcousticNetwork::EndReception(int32_t slot) {
  const Pending& pending = receptions_[static_cast<size_t>(slot)];
  const Transmission& transmission = TransmissionOf(pending.transmission);
  Reception& reception = results_.emplace_back();
  reception.packet = transmission.packet;
  reception.receiver = pending.receiver;
  reception.channel = transmission.channel;
  reception.sent_s = transmission.sent_s;
  reception.start_s = pending.start_s;
  reception.end_s = pending.end_s;
  reception.air_s = transmission.air_s;
  reception.range_m = pending.range_m;
  reception.jitter_s = pending.jitter_s;
  reception.snr_db = pending.snr_db;
  reception.loss_probability = pending.loss_probability;
  reception.bit_error_probability = pending.bit_error_probability;
  if (pending.range_m >= 0) reception.travel_s = pending.range_m / options_.sound_speed_mps;
  if (pending.lane >= 0) {
    reception.num_colliders = LaneOf(pending).NumOverlapping(pending.ticket);
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
  Release(pending.transmission);
  free_receptions_.push_back(slot);
}

AcousticFate AcousticNetwork::Decide(const Pending& pending, Reception* reception) {
  if (pending.fate) return *pending.fate;
  reception->own_number = OwnNumber(pending);
  if (reception->own_number >= 0) return AcousticFate::kHalfDuplex;
  const bool has_collided = reception->num_colliders > 0;
  if (has_collided && options_.collisions == CollisionModel::kDrop) return AcousticFate::kCollided;
  if (pending.is_lost) return AcousticFate::kLost;
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
  LaneOf(pending).ForOverlapping(
      pending.ticket, kMaxNamedColliders, [&](const AirLane::Packet& other) {
        reception->colliders[count++] = TransmissionOf(other.transmission).packet;
      });
  std::sort(reception->colliders.begin(),
            reception->colliders.begin() + static_cast<std::ptrdiff_t>(count));
}

/// Sets the bytes that the receiver gets.
AcousticFate AcousticNetwork::HandOver(const Pending& pending, Reception* reception) {
  const Transmission& transmission = TransmissionOf(pending.transmission);
  const std::span<const uint8_t> sent = transmission.bytes;
  reception->bytes = sent;
  if (reception->num_colliders == 0 && pending.num_wrong_bits == 0) {
    return AcousticFate::kDelivered;
  }
  const std::span<uint8_t> received = CopyToDamage(sent);
  reception->bytes = received;
  if (reception->num_colliders > 0) XorColliders(pending, received);
  const bool has_changed = reception->num_colliders > 0 && !std::ranges::equal(received, sent);
  reception->num_bits_flipped = pending.num_wrong_bits;
  if (pending.num_wrong_bits > 0) {
    Stream stream(KeyOf(transmission, pending.receiver).With("wrong bits"));
    FlipRandomBits(pending.num_wrong_bits, &stream, received, &scratch_);
  }
  if (has_changed) return AcousticFate::kDamagedByCollision;
  return pending.num_wrong_bits > 0 ? AcousticFate::kDamagedByBitErrors : AcousticFate::kDelivered;
}

void AcousticNetwork::XorColliders(const Pending& pending, std::span<uint8_t> received) const {
  const double bytes_per_s = options_.data_rate_bps / 8;
  const Arrival arrival = {pending.start_s, pending.end_s,
                           TransmissionOf(pending.transmission).bytes};
  const AirLane& lane = LaneOf(pending);
  lane.ForOverlapping(
      pending.ticket, lane.NumOverlapping(pending.ticket), [&](const AirLane::Packet& other) {
        XorOverlap(arrival, {other.start_s, other.end_s, TransmissionOf(other.transmission).bytes},
                   bytes_per_s, received);
      });
}

std::span<uint8_t> AcousticNetwork::CopyToDamage(std::span<const uint8_t> bytes) {
  if (num_damaged_ == damaged_.size()) damaged_.emplace_back();
  std::vector<uint8_t>& copy = damaged_[num_damaged_++];
  copy.assign(bytes.begin(), bytes.end());
  return copy;
}

int32_t AcousticNetwork::FindOrOpenLane(int32_t receiver, int32_t channel) {
  const uint64_t key = static_cast<uint64_t>(receiver) << 32 | static_cast<uint32_t>(channel);
  const auto found = lane_of_.find(key);
  if (found != lane_of_.end()) return found->second;
  if (lane_of_.size() > kMinIdleLanes + 2 * static_cast<size_t>(num_in_transit())) CloseIdleLanes();
  return lane_of_[key] = TakePlace(&lanes_, &free_lanes_);
}

void AcousticNetwork::CloseIdleLanes() {
  std::erase_if(lane_of_, [this](const auto& entry) {
    const bool is_idle = lanes_[static_cast<size_t>(entry.second)].IsIdle();
    if (is_idle) free_lanes_.push_back(entry.second);
    return is_idle;
  });
}

void AcousticNetwork::LeaveLane(const Pending& pending) {
  unneeded_.clear();
  lanes_[static_cast<size_t>(pending.lane)].End(pending.ticket, &unneeded_);
  for (const int32_t transmission : unneeded_) Release(transmission);
}

}  // namespace shoal
