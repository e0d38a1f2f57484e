#include "lib/acoustics/acoustic_network.h"

#include <cmath>
#include <limits>
#include <utility>

#include "lib/acoustics/loss_models.h"
#include "lib/check/check.h"

namespace shoal {

namespace {

/// Larger buffers are given back when their packet is gone.
constexpr size_t kKeptBufferBytes = 4096;

ChannelPlan PlanOrDie(const AcousticOptions& options, std::span<const AcousticNode> nodes) {
  Result<ChannelPlan> plan = ChannelPlan::Make(options, nodes);
  SHOAL_CHECK(plan.ok(), "options and nodes were found to be sound");
  return std::move(*plan);
}

std::optional<LinkModel> MakeLink(const AcousticOptions& options) {
  if (options.packet_loss_model != PacketLossModel::kModem &&
      options.bit_error_model != BitErrorModel::kModem) {
    return std::nullopt;
  }
  SHOAL_CHECK(options.modem.has_value(), "options and nodes were found to be sound");
  return LinkModel(*options.modem, options.sea);
}

}  // namespace

AcousticNetwork::AcousticNetwork(const AcousticOptions& options, uint64_t seed,
                                 std::span<const AcousticNode> nodes)
    : options_(options),
      plan_(PlanOrDie(options, nodes)),
      link_(MakeLink(options)),
      seed_(seed),
      now_s_(-std::numeric_limits<double>::infinity()) {
  SHOAL_CHECK(nodes.size() <= kMaxAcousticNodes, "events hold no larger index");
  for (const AcousticNode& node : nodes) {
    SHOAL_CHECK(names_.insert(node.name).second, "a node's name names its random draws");
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
                                  std::span<const uint8_t> bytes, std::span<const int> receivers) {
  SHOAL_CHECK(std::isfinite(time_s) && time_s >= now_s_, "nothing is sent in the past");
  SHOAL_CHECK(source >= 0 && source < num_nodes(), "only nodes send");
  SHOAL_CHECK(positions_m.size() == nodes_.size(), "each node has a position");
  now_s_ = time_s;
  RecycleUnused();

  Node& sender = nodes_[static_cast<size_t>(source)];
  const int32_t index = TakeTransmission(bytes);
  Transmission& transmission = transmissions_[static_cast<size_t>(index)];
  transmission.packet = {source, sender.num_sent++};
  transmission.key = sender.sends.With(transmission.packet.number);
  transmission.turn = statistics_.num_transmissions++;
  transmission.sent_s = time_s;
  transmission.air_s = 8 * static_cast<double>(bytes.size()) / options_.data_rate_bps;
  transmission.channel = plan_.SendsOn(source);
  transmission.num_users = 1;  // This call: the bytes outlive it.
  if (options_.half_duplex && !bytes.empty()) {
    ++transmission.num_users;
    events_.Push(MakeEvent(AcousticEventKind::kTransmissionStarts, time_s, transmission.turn,
                           source, index));
  }
  for (const int receiver : receivers) {
    SHOAL_CHECK(receiver >= 0 && receiver < num_nodes(), "only nodes receive");
    int64_t* last_offered = &nodes_[static_cast<size_t>(receiver)].last_offered;
    if (receiver == source || *last_offered == transmission.turn) continue;
    *last_offered = transmission.turn;
    ++transmission.num_users;
    Offer(transmission, index, receiver, positions_m);
  }
  Release(index);
  return transmission.packet.number;
}

void AcousticNetwork::Offer(const Transmission& transmission, int32_t index, int receiver,
                            std::span<const Eigen::Vector3d> positions_m) {
  const int32_t slot = TakePlace(&receptions_, &free_receptions_);
  Pending& pending = receptions_[static_cast<size_t>(slot)];
  pending = {};
  pending.start_s = transmission.sent_s;
  pending.receiver = receiver;
  pending.transmission = index;
  ++statistics_.num_offered;
  const double range_m = (positions_m[static_cast<size_t>(receiver)] -
                          positions_m[static_cast<size_t>(transmission.packet.source)])
                             .norm();
  if (!plan_.Hears(receiver, transmission.channel)) {
    pending.fate = AcousticFate::kNotListening;
  } else if (!(range_m <= kMaxRange_m)) {
    pending.fate = AcousticFate::kNoPath;
  } else {
    MeetThePath(transmission, range_m, &pending);
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

// The first number of a reception's stream is the jitter's, the second the packet loss's, whether
// or not there are such effects; the number of wrong bits comes from those that follow.
void AcousticNetwork::MeetThePath(const Transmission& transmission, double range_m,
                                  Pending* pending) const {
  Stream stream(KeyOf(transmission, pending->receiver));
  const double jitter_draw = stream.Uniform();
  const double loss_draw = stream.Uniform();
  pending->range_m = range_m;
  pending->jitter_s =
      options_.jitter == JitterModel::kUniform ? jitter_draw * options_.max_jitter_s : 0;
  pending->start_s = transmission.sent_s + (range_m / options_.sound_speed_mps + pending->jitter_s);
  const double wrong_by_modem = link_ ? MeetTheModem(range_m, pending) : 0;
  if (options_.packet_loss_model != PacketLossModel::kOff) {
    pending->loss_probability =
        options_.packet_loss_model == PacketLossModel::kModem
            ? PacketErrorRate(wrong_by_modem, transmission.bytes.size(), options_.modem->code)
            : PacketLossProbability(options_, range_m,
                                    plan_.channel(transmission.channel).freq_khz);
    pending->is_lost = loss_draw < pending->loss_probability;
  }
  if (options_.bit_error_model != BitErrorModel::kOff) {
    pending->bit_error_probability = options_.bit_error_model == BitErrorModel::kModem
                                         ? wrong_by_modem
                                         : BitErrorProbability(options_, range_m);
    pending->num_wrong_bits = stream.Binomial(static_cast<int64_t>(8 * transmission.bytes.size()),
                                              pending->bit_error_probability);
  }
}

/// Returns the probability that a bit is wrong in the water.
double AcousticNetwork::MeetTheModem(double range_m, Pending* pending) const {
  const LinkBudget link = link_->At(range_m);
  pending->snr_db = link.snr_db;
  return link.bit_error_rate;
}

std::span<const Reception> AcousticNetwork::Deliver(double until_s) {
  SHOAL_CHECK(until_s >= now_s_, "time moves forward");
  now_s_ = until_s;
  RecycleUnused();
  while (events_.HasEventUntil(until_s)) {
    const AcousticEvent event = events_.First();
    if (event.kind() == AcousticEventKind::kReceptionStarts) {
      StartReception(event.slot);
      events_.ReplaceFirst(EndOf(event, receptions_[static_cast<size_t>(event.slot)].end_s));
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

int32_t AcousticNetwork::TakeTransmission(std::span<const uint8_t> bytes) {
  const int32_t index = TakePlace(&transmissions_, &free_transmissions_);
  transmissions_[static_cast<size_t>(index)].bytes.assign(bytes.begin(), bytes.end());
  return index;
}

void AcousticNetwork::Release(int32_t transmission) {
  if (--transmissions_[static_cast<size_t>(transmission)].num_users == 0) {
    unused_transmissions_.push_back(transmission);
  }
}

void AcousticNetwork::RecycleUnused() {
  results_.clear();
  num_damaged_ = 0;
  for (const int32_t index : unused_transmissions_) {
    std::vector<uint8_t>& bytes = transmissions_[static_cast<size_t>(index)].bytes;
    if (bytes.capacity() > kKeptBufferBytes) bytes = {};
    free_transmissions_.push_back(index);
  }
  unused_transmissions_.clear();
}

}  // namespace shoal
