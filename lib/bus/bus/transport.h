// Datagrams on numbered ports: what stepping needs of a network. LcmTransport is the real one;
// tests have one that loses chosen datagrams.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace shoal {

class Transport {
 public:
  using Receiver =
      std::function<void(int port, std::string_view channel, std::span<const uint8_t> datagram)>;

  virtual ~Transport() = default;

  /// Sends a datagram to all listeners of `channel` on `port`, this object included. What is
  /// lost comes again by the step protocol.
  virtual void Send(int port, std::string_view channel, std::span<const uint8_t> datagram) = 0;

  /// Receives `channel` on `port` from now on.
  virtual void Listen(int port, const std::string& channel) = 0;

  /// Receives every channel on `port` from now on.
  virtual void ListenToAll(int port) = 0;

  /// Datagrams that were no messages, and messages that came in part.
  virtual int64_t num_refused() const { return 0; }
};

}  // namespace shoal
