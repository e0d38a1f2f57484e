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

Mediator::Mediator(std::string vehicle, const MessageOptions& options, Bus& bus, StatusLog* log)
    : vehicle_(std::move(vehicle)), options_(options), bus_(bus), log_(log) {
  Subscribe(bus, channels::MediatedMessage(vehicle_),
            [this](const node_message_t& message) { to_send_.push_back(message); });
  Subscribe(bus, channels::NodeMessage(vehicle_), [this](const node_message_t& message) {
    if (message.ack_requested == 0) return;
    if (to_acknowledge_.size() == kMaxAcksPerStep || message.ack_id.size() > kLongestAckId) {
      ++counters_.acks_unsent;
      log_->Warn("messages not acknowledged: too many in one step, or too long an ack_id");
      return;
    }
    ack_message_t ack;
    ack.src_node = vehicle_;
    ack.dest_node = message.src_node;
    ack.ack_id = message.ack_id;
    to_acknowledge_.push_back(std::move(ack));
  });
  Subscribe(bus, channels::AckMessageTo(vehicle_),
            [this](const ack_message_t& ack) { received_acks_.push_back(ack); });
}

void Mediator::Tick(int64_t utime) {
  for (ack_message_t& ack : to_acknowledge_) {
    ack.utime = utime;
    Publish(bus_, channels::AckMessage(), ack);
    ++counters_.acks_sent;
  }
  for (const ack_message_t& ack : received_acks_) TakeAck(utime, ack);
  for (node_message_t& message : to_send_) Send(utime, std::move(message));
  to_acknowledge_.clear();
  received_acks_.clear();
  to_send_.clear();
  Repeat(utime);
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
  WaitingMessage entry{.message = message, .silent = {}, .sent_utime = utime, .num_repeats = 0};
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
    const double silence_s = Seconds(utime - each.sent_utime);
    if (silence_s < options_.ack_timeout_s) {
      ++entry;
    } else if (each.num_repeats < options_.max_repeats) {
      each.sent_utime = utime;
      ++each.num_repeats;
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
