// How many bytes wait in the receive buffers of other processes, as the kernel reports them. A
// sender that waits while they are many loses nothing to these processes, be they shoal's or not.
//
//   PacedTransport transport(&lcm, ports, WaitForReceivers);
#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/transport.h"

namespace shoal {

/// One UDP socket of another process.
struct ReceiverQueue {
  std::string inode;
  int64_t waiting_bytes = 0;  ///< As the kernel counts them: a small datagram has some 800.
};

/// Reads the table of /proc/net/udp: the sockets bound to one of `ports`, without those in `own`.
[[nodiscard]] std::vector<ReceiverQueue> ParseQueues(std::istream& table,
                                                     const std::set<int>& ports,
                                                     const std::set<std::string, std::less<>>& own);

/// The inodes of this process's sockets.
[[nodiscard]] std::set<std::string, std::less<>> OwnSocketInodes();

/// The queues of other processes, looked at often. Listing the own sockets costs far more than
/// reading the table, so that they are listed again only when a socket appears that is not known.
class ForeignQueues {
 public:
  using Inodes = std::set<std::string, std::less<>>;

  /// `list_own` returns the inodes of this process's sockets.
  explicit ForeignQueues(std::set<int> ports, std::function<Inodes()> list_own = OwnSocketInodes);

  /// Reads the table of /proc/net/udp.
  [[nodiscard]] std::vector<ReceiverQueue> In(std::istream& table);

 private:
  const std::set<int> ports_;
  const std::function<Inodes()> list_own_;
  Inodes own_;
  Inodes foreign_;
};

/// Sends through another transport, and lets the receivers keep up.
class PacedTransport : public Transport {
 public:
  /// It looks at the receivers' buffers after as many datagrams, or bytes. The smallest buffer (208
  /// KiB by default) has room for both: these, and kMaxWaiting_bytes.
  static constexpr int kDatagramsBetweenLooks = 32;
  static constexpr int64_t kBytesBetweenLooks = 48 << 10;
  /// It waits while a receiver has more than this unread ...
  static constexpr int64_t kMaxWaiting_bytes = 64 << 10;
  /// ... but after this time no longer for one that reads nothing at all: it is stopped, or hangs.
  static constexpr int64_t kPatience_us = 1'000'000;

  using Look = std::function<std::vector<ReceiverQueue>()>;
  using Pause = std::function<void(int64_t us)>;

  /// `look` returns the receivers' queues, `pause` waits.
  PacedTransport(Transport* inner, Look look, Pause pause);

  void Send(int port, std::string_view channel, std::span<const uint8_t> datagram) override;
  void Listen(int port, const std::string& channel) override { inner_.Listen(port, channel); }
  void ListenToAll(int port) override { inner_.ListenToAll(port); }
  int64_t num_refused() const override { return inner_.num_refused(); }

  /// How many receivers it stopped waiting for; each counts once.
  int64_t num_given_up() const { return static_cast<int64_t>(ever_given_up_.size()); }
  /// Microseconds spent waiting.
  int64_t waited_us() const { return waited_us_; }

 private:
  void WaitForReceivers();

  Transport& inner_;
  const Look look_;
  const Pause pause_;
  int num_sent_ = 0;
  int64_t num_bytes_ = 0;
  int64_t waited_us_ = 0;
  /// Receivers that read nothing for too long, and the bytes that they had not read then.
  std::map<std::string, int64_t, std::less<>> given_up_;
  std::set<std::string, std::less<>> ever_given_up_;
};

}  // namespace shoal
