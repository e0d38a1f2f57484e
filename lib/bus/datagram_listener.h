// Receives LCM messages of one datagram on many ports in one thread, without LCM: for programs that
// watch a mission and must leave it as much of the machine as possible. (LCM keeps a thread
// per port, which wakes for each datagram and hands it on through a pipe.)
//
//   DatagramListener listener({18003, 18004});
//   while (true) listener.Poll(100, [](std::string_view channel, auto datagram) { ... });
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
  /// Receives all channels, or those that begin with one of `topics`: the kernel throws the others
  /// away.
  /// @pre every topic has at least four characters; the first four count
  explicit DatagramListener(std::span<const int> ports,
                            std::span<const std::string_view> topics = {});
  ~DatagramListener();
  DatagramListener(const DatagramListener&) = delete;
  DatagramListener& operator=(const DatagramListener&) = delete;

  /// Waits at most `timeout_ms`, then hands what has arrived to `handler`: all of it, or some
  /// thousands. A message may have its seal (lib/bus/seal.h). Those of several datagrams, more than
  /// 64 KB, are left out.
  void Poll(int timeout_ms,
            const std::function<void(std::string_view channel, std::span<const uint8_t> datagram)>&
                handler);

  /// Empty, or why it does not work.
  const std::string& error() const { return error_; }

 private:
  void Open(int port, std::span<const std::string_view> topics);
  /// Hands at most one batch of `opened` to `handler`. Returns how many datagrams came.
  int Receive(int opened,
              const std::function<void(std::string_view, std::span<const uint8_t>)>& handler);

  int epoll_ = -1;
  std::vector<int> sockets_;
  std::vector<uint8_t> bytes_;
  std::string error_;
};

}  // namespace shoal
