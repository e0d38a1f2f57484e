#include "apps/shore_broker/broker_inbox.h"

#include "lib/bus/channels.h"

namespace shoal {

BrokerInbox::BrokerInbox(Bus& bus) {
  Keep(bus, channels::NodeReportLocal().name, false, &reports_);
  Keep(bus, channels::NodeReportFromOutside().name, true, &reports_);
  Keep(bus, channels::NodeMessageLocal().name, false, &messages_);
  Keep(bus, channels::NodeMessageFromOutside().name, true, &messages_);
  Keep(bus, channels::AckMessage().name, false, &acks_);
  Keep(bus, channels::RelayTx().name, false, &relays_);
  Keep(bus, channels::AcousticTx().name, false, &packets_);
  Keep(bus, channels::ModemTx().name, true, &packets_);
  Keep(bus, channels::HelmCommandAll().name, false, &commands_);
}

void BrokerInbox::Keep(Bus& bus, const std::string& channel, bool from_outside,
                       std::vector<Item>* list) {
  bus.SubscribeBytes(channel, [this, list, from_outside](const Message& message) {
    list->push_back(
        {.begin = arena_.size(), .size = message.data.size(), .from_outside = from_outside});
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
