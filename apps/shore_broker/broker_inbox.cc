#include "apps/shore_broker/broker_inbox.h"

#include "lib/bus/channels.h"

namespace shoal {

BrokerInbox::BrokerInbox(Bus& bus) {
  Keep(bus, channels::NodeReportLocal().name, {}, &reports_);
  Keep(bus, channels::NodeReportFromOutside().name, {.from_outside = true}, &reports_);
  Keep(bus, channels::NodeMessageLocal().name, {}, &messages_);
  Keep(bus, channels::NodeMessageFromOutside().name, {.from_outside = true}, &messages_);
  Keep(bus, channels::AckMessage().name, {}, &acks_);
  Keep(bus, channels::RelayTx().name, {}, &relays_);
  Keep(bus, channels::AcousticTx().name, {.packet = Packet::kAcousticTx}, &packets_);
  Keep(bus, channels::AcousticTxOn().name, {.packet = Packet::kAcousticTxOn}, &packets_);
  Keep(bus, channels::ModemTx().name, {.packet = Packet::kModemTx}, &packets_);
  Keep(bus, channels::HelmCommandAll().name, {}, &commands_);
}

void BrokerInbox::Keep(Bus& bus, const std::string& channel, const Item& kind,
                       std::vector<Item>* list) {
  bus.SubscribeBytes(channel, [this, list, kind](const Message& message) {
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
