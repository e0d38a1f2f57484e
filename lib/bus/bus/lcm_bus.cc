#include "lib/bus/bus/lcm_bus.h"

#include "lib/bus/bus/seal.h"

namespace shoal {

LcmBus::LcmBus(PortPlan plan, FilterPlace place) : plan_(std::move(plan)), transport_(place) {
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

void LcmBus::set_limits(const PollLimits& limits) {
  limits_ = limits;
  if (limits_.most > 0) transport_.StampArrivals();
}

void LcmBus::Poll(int64_t timeout_us) {
  num_in_poll_.clear();
  num_handled_in_poll_ = 0;
  transport_.Poll(timeout_us);
  // Under a flood the late ones are read too, to be dropped. They are read faster than they can
  // come; should they not be, the caller gets its turn nevertheless.
  constexpr int kMaxPolls = 50;
  for (int i = 0; i < kMaxPolls && limits_.most > 0 && num_handled_in_poll_ < limits_.most &&
                  transport_.has_more();
       ++i) {
    transport_.Poll(0);
  }
}

/// Counts a message; returns true where it comes too late to be handled.
bool LcmBus::IsTooLate(std::string_view channel) {
  constexpr int64_t kAlwaysHandled = 20;
  auto found = num_in_poll_.find(channel);
  if (found == num_in_poll_.end()) found = num_in_poll_.emplace(channel, 0).first;
  return ++found->second > kAlwaysHandled && transport_.arrived_utime() < limits_.oldest_utime;
}

void LcmBus::Dispatch(std::string_view channel, std::span<const uint8_t> datagram) {
  if (limits_.most > 0) {
    if (IsTooLate(channel)) {
      ++counters_.overload;
      return;
    }
    if (++num_handled_in_poll_ >= limits_.most) transport_.EndPoll();
  }
  const Unsealed unsealed = Unseal(datagram);
  if (mission_id_ != 0 && unsealed.seal && unsealed.seal->mission_id != mission_id_) return;
  if (secret_ && unsealed.seal && !IsGenuine(unsealed, *secret_, channel)) {
    ++counters_.forged;
    return;
  }
  counters_.handled +=
      handlers_.Call({.channel = channel,
                      .publisher = unsealed.seal ? unsealed.seal->publisher : std::string_view(),
                      .data = unsealed.message});
}

}  // namespace shoal
