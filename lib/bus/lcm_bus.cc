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

void LcmBus::Poll(int64_t timeout_us) {
  num_in_poll_.clear();
  transport_.Poll(timeout_us);
  // Under a flood the rest is read too, to be dropped: it would only grow old. It is read faster
  // than it can come; should it not be, the caller gets its turn nevertheless.
  constexpr int kMostRounds = 50;
  for (int i = 0; i < kMostRounds && most_per_poll_ > 0 && transport_.has_more(); ++i) {
    transport_.Poll(0);
  }
}

/// Counts a message; returns true where its channel has had what a Poll may handle.
bool LcmBus::IsTooMuch(std::string_view channel) {
  auto found = num_in_poll_.find(channel);
  if (found == num_in_poll_.end()) found = num_in_poll_.emplace(channel, 0).first;
  return ++found->second > most_per_poll_;
}

void LcmBus::Dispatch(std::string_view channel, std::span<const uint8_t> datagram) {
  if (most_per_poll_ > 0 && IsTooMuch(channel)) {
    ++counters_.overload;
    return;
  }
  const Unsealed unsealed = Unseal(datagram);
  counters_.handled +=
      handlers_.Call({.channel = channel,
                      .publisher = unsealed.seal ? unsealed.seal->publisher : std::string_view(),
                      .data = unsealed.message});
}

}  // namespace shoal
