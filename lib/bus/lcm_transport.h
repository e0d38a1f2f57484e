// Transport over LCM: one LCM object per port, queues without limit, buffers as large as allowed.
//
//   LcmTransport transport;
//   transport.set_receiver([&](int port, std::string_view channel, auto datagram) { ... });
//   transport.Listen(7667, "NODE_REPORT_LOCAL");
//   if (!transport.error().empty()) { ...exit 3... }
//   while (true) transport.Poll(100'000);
//
// One thread. (LCM itself keeps a reader thread per port that is listened to.)
#pragma once

#include <lcm/lcm.h>
#include <poll.h>

#include <memory>
#include <string>
#include <vector>

#include "lib/bus/transport.h"

namespace shoal {

class LcmTransport : public Transport {
 public:
  LcmTransport();
  ~LcmTransport() override;
  LcmTransport(const LcmTransport&) = delete;
  LcmTransport& operator=(const LcmTransport&) = delete;

  void set_receiver(Receiver receiver) { receiver_ = std::move(receiver); }

  void Send(int port, std::string_view channel, std::span<const uint8_t> datagram) override;
  void Listen(int port, const std::string& channel) override;
  void ListenToAll(int port) override;

  /// Waits at most `timeout_us` for datagrams (or for `extra_fd` to be readable, if not negative),
  /// then hands all that are there to the receiver. Returns true where `extra_fd` is readable.
  bool Poll(int64_t timeout_us, int extra_fd = -1);
  /// True where the last Poll left datagrams for the next: a flood must not starve its caller.
  bool has_more() const { return has_more_; }
  /// Makes the running Poll return soon, and leave the rest for the next. Called by the receiver.
  void EndPoll() { ends_poll_ = true; }
  /// When the datagram that the receiver is given reached this machine's socket: microseconds since
  /// 1970.
  int64_t arrived_utime() const { return arrived_utime_; }

  /// Empty, or why a port could not be opened, with what to try.
  const std::string& error() const { return error_; }

  /// Datagrams that could not be sent, or not wholly.
  int64_t num_failed_sends() const { return num_failed_sends_; }

  /// Fault injection: datagrams for which `drop` returns true are lost on arrival.
  void set_drop_filter(std::function<bool(std::string_view channel)> drop) {
    drop_ = std::move(drop);
  }

 private:
  struct Port;
  Port* Open(int port);
  void Subscribe(int port, const std::string& regex);
  static void OnLcmMessage(const lcm_recv_buf_t* buffer, const char* channel, void* user);

  Receiver receiver_;
  std::function<bool(std::string_view)> drop_;
  std::vector<std::unique_ptr<Port>> ports_;  ///< In order of port number.
  std::vector<pollfd> descriptors_;           ///< Of a Poll; kept for its memory, like the next.
  std::vector<Port*> listening_;
  std::string error_;
  int64_t num_failed_sends_ = 0;
  bool has_more_ = false;
  bool ends_poll_ = false;
  int64_t arrived_utime_ = 0;
};

}  // namespace shoal
