// A bus over LCM for programs that do not take part in stepping: tools, viewers, scripts. Handlers
// run in Poll, at arrival; what is published counts as from outside.
//
//   LcmBus bus(plan);
//   Subscribe(bus, channels::Appcast(), [](const appcast_t& page) { ... });
//   Publish(bus, channels::HelmCommand("alpha"), command);
//   bus.Poll(100'000);
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/handler_table.h"
#include "lib/bus/bus/layout.h"
#include "lib/bus/bus/lcm_transport.h"
#include "lib/bus/bus/mission_secret.h"

namespace shoal {

/// What a Poll does in overload.
struct PollLimits {
  /// Handles about as many messages; the rest waits for the next Poll. 0: no limit.
  int64_t most = 0;
  /// Drops what arrived before this (microseconds since 1970) and counts it as overload; but a few
  /// messages of each channel are handled however late they are, so that a flood on one channel
  /// does not silence the others.
  int64_t oldest_utime = 0;
};

class LcmBus : public Bus {
 public:
  explicit LcmBus(PortPlan plan, FilterPlace place = FilterPlace::kKernel);

  void PublishBytes(std::string_view channel, std::span<const uint8_t> data) override;
  void SubscribeBytes(const std::string& channel, Handler handler) override;
  void SubscribeAll(Handler handler) override;

  /// Waits at most `timeout_us` for messages and handles all that are there.
  void Poll(int64_t timeout_us);

  /// Handles no sealed messages of other missions from now on. (What comes from outside the step
  /// protocol has no seal.)
  void set_mission_id(int64_t mission_id) { mission_id_ = mission_id; }

  /// Drops sealed messages that were not sealed with the mission's secret from now on. Without it
  /// no seal is verified.
  void set_secret(const MissionSecret& secret) { secret_ = secret; }

  /// Holds for the Polls from now on.
  void set_limits(const PollLimits& limits);

  /// Datagrams that were no messages, and messages that came in part.
  int64_t num_refused() const { return transport_.num_refused(); }
  /// Messages that could not be sent, or not wholly.
  int64_t num_failed_sends() const { return transport_.num_failed_sends(); }

  /// Empty, or why the bus does not work, with what to try.
  const std::string& error() const { return transport_.error(); }

 private:
  bool IsTooLate(std::string_view channel);
  void Dispatch(std::string_view channel, std::span<const uint8_t> datagram);

  PortPlan plan_;
  LcmTransport transport_;
  HandlerTable handlers_;
  PollLimits limits_;
  int64_t mission_id_ = 0;  ///< 0: any.
  std::optional<MissionSecret> secret_;
  int64_t num_handled_in_poll_ = 0;
  std::map<std::string, int64_t, std::less<>> num_in_poll_;  ///< Messages, by channel.
};

}  // namespace shoal
