// A bus over LCM for those who do not take part in stepping: tools, viewers, scripts. Handlers run
// in Poll, at arrival; what is published counts as said from outside.
//
//   LcmBus bus(plan);
//   Subscribe(bus, channels::Appcast(), [](const appcast_t& page) { ... });
//   Publish(bus, channels::HelmCommand("alpha"), command);
//   bus.Poll(100'000);
#pragma once

#include <functional>
#include <map>
#include <string>

#include "lib/bus/bus.h"
#include "lib/bus/handler_table.h"
#include "lib/bus/layout.h"
#include "lib/bus/lcm_transport.h"

namespace shoal {

class LcmBus : public Bus {
 public:
  explicit LcmBus(PortPlan plan);

  void PublishBytes(std::string_view channel, std::span<const uint8_t> data) override;
  void SubscribeBytes(const std::string& channel, Handler handler) override;
  void SubscribeAll(Handler handler) override;

  /// Waits at most `timeout_us` for messages and handles all that are there.
  void Poll(int64_t timeout_us);

  /// From now on a Poll reads all that has arrived, but handles no more messages of a channel than
  /// this; the others are counted as overload.
  void set_most_per_poll(int64_t most) { most_per_poll_ = most; }

  /// Empty, or why the bus does not work, with what to try.
  const std::string& error() const { return transport_.error(); }

 private:
  bool IsTooMuch(std::string_view channel);
  void Dispatch(std::string_view channel, std::span<const uint8_t> datagram);

  PortPlan plan_;
  LcmTransport transport_;
  HandlerTable handlers_;
  int64_t most_per_poll_ = 0;                                ///< 0: no limit.
  std::map<std::string, int64_t, std::less<>> num_in_poll_;  ///< Messages, by channel.
};

}  // namespace shoal
