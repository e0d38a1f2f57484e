#include "apps/node_reporter/mediator.h"

#include <fmt/format.h>

#include <utility>

#include "lib/base/text/letters.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/routing/destinations.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {

size_t SizeOf(const node_message_t& message) {
  return static_cast<size_t>(message.getEncodedSize());
}

}  // namespace

Mediator::Mediator(std::string vehicle, const MessageOptions& options, uint64_t seed, Bus& bus,
                   StatusLog* log)
    : vehicle_(std::move(vehicle)),
      options_(options),
      ack_key_(StreamKey(seed, "ack jitter").With(vehicle_)),
      repeat_key_(StreamKey(seed, "repeat jitter").With(vehicle_)),
      bus_(bus),
      log_(log) {
  Subscribe(bus, channels::MediatedMessage(vehicle_),
            [this](const node_message_t& message) { to_send_.push_back(message); });
  Subscribe(bus, channels::NodeMessage(vehicle_), [this](const node_message_t& message) {
    if (message.ack_requested == 0) return;
    if (num_acks_of_step_ == kMaxAcksPerStep || to_acknowledge_.size() == kMaxAcksWaiting ||
        message.ack_id.size() > kLongestAckId) {
      ++counters_.acks_unsent;
      log_->Warn("messages not acknowledged: too many in one step, or too long an ack_id");
      return;
    }
    ack_message_t ack;
    ack.src_node = vehicle_;
    ack.dest_node = message.src_node;
    ack.ack_id = message.ack_id;
    ++num_acks_of_step_;
    to_acknowledge_.push_back({.ack = std::move(ack), .due_utime = {}});
  });
  Subscribe(bus, channels::AckMessageTo(vehicle_),
            [this](const ack_message_t& ack) { received_acks_.push_back(ack); });
}

void Mediator::Tick(int64_t utime) {
  num_acks_of_step_ = 0;
  Acknowledge(utime);
  for (const ack_message_t& ack : received_acks_) TakeAck(utime, ack);
  for (node_message_t& message : to_send_) Send(utime, std::move(message));
  received_acks_.clear();
  to_send_.clear();
  Repeat(utime);
}

void Mediator::Acknowledge(int64_t utime) {
  std::erase_if(to_acknowledge_, [&](WaitingAck& waiting) {
    if (!waiting.due_utime) {
      const double uniform = Stream(ack_key_.With(num_acks_++)).Uniform();
      waiting.due_utime = utime + Microseconds(options_.ack_jitter_s * uniform);
    }
    if (*waiting.due_utime > utime) return false;
    waiting.ack.utime = utime;
    Publish(bus_, channels::AckMessage(), waiting.ack);
    ++counters_.acks_sent;
    return true;
  });
}

int64_t Mediator::RepeatUtime(int64_t utime, const WaitingMessage& entry) const {
  const double uniform = Stream(repeat_key_.With(entry.number).With(entry.num_repeats)).Uniform();
  return utime + Microseconds(options_.ack_timeout_s + options_.repeat_jitter_s * uniform);
}

void Mediator::Send(int64_t utime, node_message_t message) {
  const int64_t number = counters_.given++;
  const auto refuse = [&](std::string_view why) {
    ++counters_.refused;
    log_->Warn(fmt::format("message on MEDIATED_MESSAGE_{} refused: {}", UpperCase(vehicle_), why));
  };
  if (message.src_node.empty()) message.src_node = vehicle_;
  if (VehicleKey(message.src_node) != VehicleKey(vehicle_)) {
    return refuse("src_node is another vehicle");
  }
  // The time keeps the id a new one when this process is started again.
  if (message.ack_id.empty()) {
    message.ack_id = fmt::format("{}-{}-{}", vehicle_, utime / 1000, number);
  }
  if (waiting_.contains(message.ack_id)) return refuse("its ack_id waits already");
  if (waiting_.size() == kMaxWaiting) return refuse("too many wait to be acknowledged");
  message.ack_requested = 1;
  if (message.utime == 0) message.utime = utime;
  if (waiting_bytes_ + SizeOf(message) > kMaxWaitingBytes) {
    return refuse("too many bytes wait to be acknowledged");
  }

  const Destinations named = ParseDestinations(message.dest_node);
  WaitingMessage entry{
      .message = message, .silent = {}, .repeat_utime = 0, .number = number, .num_repeats = 0};
  entry.repeat_utime = RepeatUtime(utime, entry);
  if (!named.all && message.dest_group.empty()) {
    for (const std::string& name : named.names) entry.silent.insert(VehicleKey(name));
    entry.silent.erase(VehicleKey(vehicle_));  // No vehicle receives its own messages.
  }
  Publish(bus_, channels::NodeMessageLocal(), message);
  waiting_bytes_ += SizeOf(message);
  waiting_.emplace(message.ack_id, std::move(entry));
}

void Mediator::TakeAck(int64_t utime, const ack_message_t& ack) {
  const auto found = waiting_.find(ack.ack_id);
  if (found == waiting_.end()) {
    ++counters_.acks_unexpected;
    return;
  }
  std::set<std::string>& silent = found->second.silent;
  if (!silent.empty() && silent.erase(VehicleKey(ack.src_node)) == 0) {
    ++counters_.acks_unexpected;
    return;
  }
  if (!silent.empty()) return;
  ++counters_.acknowledged;
  log_->Event(utime, fmt::format("message {} ({}) is acknowledged", Printable(ack.ack_id),
                                 Printable(found->second.message.var_name)));
  Remove(found);
}

std::map<std::string, Mediator::WaitingMessage>::iterator Mediator::Remove(
    std::map<std::string, WaitingMessage>::iterator entry) {
  waiting_bytes_ -= SizeOf(entry->second.message);
  return waiting_.erase(entry);
}

void Mediator::Repeat(int64_t utime) {
  for (auto entry = waiting_.begin(); entry != waiting_.end();) {
    WaitingMessage& each = entry->second;
    if (utime < each.repeat_utime) {
      ++entry;
    } else if (each.num_repeats < options_.max_repeats) {
      ++each.num_repeats;
      each.repeat_utime = RepeatUtime(utime, each);
      ++counters_.repeats;
      Publish(bus_, channels::NodeMessageLocal(), each.message);
      ++entry;
    } else {
      ++counters_.given_up;
      log_->Event(utime, fmt::format("message {} ({}) is given up: no ack after {} repeats",
                                     Printable(entry->first), Printable(each.message.var_name),
                                     each.num_repeats));
      entry = Remove(entry);
    }
  }
}

}  // namespace shoal
