// Hears LCM messages of one datagram on many ports in one thread, without LCM: a receiver that
// takes as little of the machine as it can from the broker that it measures. (LCM keeps a thread
// per port and hands each message on through a pipe.)
//
//   DatagramListener listener({18003, 18004});
//   while (true) listener.Poll(100, [](std::string_view channel, auto message) { ... });
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

class DatagramListener {
 public:
  explicit DatagramListener(std::span<const int> ports);
  ~DatagramListener();
  DatagramListener(const DatagramListener&) = delete;
  DatagramListener& operator=(const DatagramListener&) = delete;

  /// Waits at most `timeout_ms`, then hands all that has arrived to `handler`. Messages of several
  /// datagrams are left out.
  void Poll(int timeout_ms,
            const std::function<void(std::string_view channel, std::span<const uint8_t> message)>&
                handler);

  /// Empty, or why it does not work.
  const std::string& error() const { return error_; }

 private:
  void Open(int port);

  int epoll_ = -1;
  std::vector<int> sockets_;
  std::vector<uint8_t> bytes_;
  std::string error_;
};

}  // namespace shoal
