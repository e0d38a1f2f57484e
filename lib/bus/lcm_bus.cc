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
  if (handlers_.Add(channel, std::move(handler))) {
    transport_.Listen(plan_.PortOf(channel), channel);
  }
}

void LcmBus::SubscribeAll(Handler handler) {
  SHOAL_CHECK(handlers_.empty(), "SubscribeAll comes before any other subscription");
  handlers_.AddForAll(std::move(handler));
  for (const int port : plan_.DataPorts()) transport_.ListenToAll(port);
}

void LcmBus::Dispatch(std::string_view channel, std::span<const uint8_t> datagram) {
  const Unsealed unsealed = Unseal(datagram);
  counters_.handled +=
      handlers_.Call({.channel = channel,
                      .publisher = unsealed.seal ? unsealed.seal->publisher : std::string_view(),
                      .data = unsealed.message});
}

}  // namespace shoal
