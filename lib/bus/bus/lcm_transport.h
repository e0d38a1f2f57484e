// Transport over LCM's UDP multicast: sends through liblcm, receives through LcmReceiver.
//
//   LcmTransport transport;
//   transport.set_receiver([&](int port, std::string_view channel, auto datagram) { ... });
//   transport.Listen(7667, "NODE_REPORT_LOCAL");
//   if (!transport.error().empty()) { ...exit 3... }
//   while (true) transport.Poll(100'000);
//
// One thread, none of its own.
#pragma once

#include <lcm/lcm.h>

#include <map>
#include <string>

#include "lib/bus/bus/lcm_receiver.h"
#include "lib/bus/bus/transport.h"

namespace shoal {

class LcmTransport : public Transport {
 public:
  explicit LcmTransport(FilterPlace place = FilterPlace::kKernel);
  ~LcmTransport() override;
  LcmTransport(const LcmTransport&) = delete;
  LcmTransport& operator=(const LcmTransport&) = delete;

  void set_receiver(Receiver receiver) { receiver_ = std::move(receiver); }

  void Send(int port, std::string_view channel, std::span<const uint8_t> datagram) override;
  void Listen(int port, const std::string& channel) override {
    lcm_receiver_.Listen(port, channel);
  }
  void ListenToAll(int port) override { lcm_receiver_.ListenToAll(port); }
  int64_t num_refused() const override { return lcm_receiver_.num_refused(); }

  /// As LcmReceiver's.
  void DeferFrom(int port) { lcm_receiver_.DeferFrom(port); }
  bool Poll(int64_t timeout_us, int extra_fd = -1, WakeFor wake_for = WakeFor::kAll);
  int fd() const { return lcm_receiver_.fd(); }
  bool has_more() const { return lcm_receiver_.has_more(); }
  void EndPoll() { lcm_receiver_.EndPoll(); }
  void StampArrivals() { lcm_receiver_.StampArrivals(); }
  int64_t arrived_utime() const { return lcm_receiver_.arrived_utime(); }

  /// Empty, or why a port could not be opened, with what to try.
  const std::string& error() const { return error_.empty() ? lcm_receiver_.error() : error_; }

  /// Datagrams that could not be sent, or not wholly.
  int64_t num_failed_sends() const { return num_failed_sends_; }

  /// Fault injection: datagrams for which `drop` returns true are lost on arrival.
  void set_drop_filter(std::function<bool(std::string_view channel)> drop) {
    drop_ = std::move(drop);
  }

 private:
  lcm_t* Open(int port);
  void Take(int port, std::string_view channel, std::span<const uint8_t> datagram);

  Receiver receiver_;
  std::function<bool(std::string_view)> drop_;
  LcmReceiver lcm_receiver_;
  const LcmReceiver::Handler take_;
  std::map<int, lcm_t*> senders_;  ///< By port; null: could not be opened.
  std::string error_;
  int64_t num_failed_sends_ = 0;
};

}  // namespace shoal
