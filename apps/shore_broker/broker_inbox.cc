#include "apps/shore_broker/broker_inbox.h"

namespace shoal {

BrokerInbox::BrokerInbox(Takes takes, Bus& bus, StatusLog* log) : bus_(bus), log_(*log) {
  Keep(channels::NodeReportLocal().name, {}, &reports_);
  Keep(channels::NodeReportFromOutside().name, {.from_outside = true}, &reports_);
  if (takes == Takes::kReports) return;
  Keep(channels::NodeMessageLocal().name, {}, &messages_);
  Keep(channels::NodeMessageFromOutside().name, {.from_outside = true}, &messages_);
  Keep(channels::AckMessage().name, {}, &acks_);
  Keep(channels::RelayTx().name, {}, &relays_);
  Keep(channels::AcousticTx().name, {.packet = Packet::kAcousticTx}, &packets_);
  Keep(channels::AcousticTxOn().name, {.packet = Packet::kAcousticTxOn}, &packets_);
  Keep(channels::ModemTx().name, {.packet = Packet::kModemTx}, &packets_);
  Keep(channels::HelmCommandAll().name, {}, &commands_);
}

void BrokerInbox::Keep(const std::string& channel, const Item& kind, std::vector<Item>* list) {
  bus_.SubscribeBytes(channel, [this, list, kind](const Message& message) {
    Item& item = list->emplace_back(kind);
    item.begin = arena_.size();
    item.size = message.data.size();
    arena_.insert(arena_.end(), message.data.begin(), message.data.end());
  });
}

void BrokerInbox::Clear() {
  reports_.clear();
  messages_.clear();
  acks_.clear();
  relays_.clear();
  packets_.clear();
  arena_.clear();
}

}  // namespace shoal
