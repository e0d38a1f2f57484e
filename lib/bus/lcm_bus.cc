#include "lib/bus/lcm_bus.h"

#include "lib/bus/seal.h"

namespace shoal {

LcmBus::LcmBus(PortPlan plan) : plan_(std::move(plan)) {
  transport_.set_receiver([this](int, std::string_view channel, std::span<const uint8_t> datagram) {
    Dispatch(channel, datagram);
  });
}

void LcmBus::PublishBytes(std::string_view channel, std::span<const uint8_t> data) {
  transport_.Send(plan_.PortOf(channel), channel, data);
  ++counters_.published;
}

void LcmBus::SubscribeBytes(const std::string& channel, Handler handler) {
  std::vector<Handler>& handlers = handlers_[channel];
  if (handlers.empty()) transport_.Listen(plan_.PortOf(channel), channel);
  handlers.push_back(std::move(handler));
}

void LcmBus::SubscribeAll(Handler handler) {
  if (all_handlers_.empty()) {
    for (const int port : plan_.DataPorts()) transport_.ListenToAll(port);
  }
  all_handlers_.push_back(std::move(handler));
}

void LcmBus::Dispatch(std::string_view channel, std::span<const uint8_t> datagram) {
  const Unsealed unsealed = Unseal(datagram);
  const Message message{.channel = channel,
                        .publisher = unsealed.seal ? unsealed.seal->publisher : std::string_view(),
                        .data = unsealed.message};
  const auto found = handlers_.find(channel);
  if (found != handlers_.end()) {
    for (const Handler& handler : found->second) {
      ++counters_.handled;
      handler(message);
    }
  }
  for (const Handler& handler : all_handlers_) {
    ++counters_.handled;
    handler(message);
  }
}

}  // namespace shoal
