// Receives LCM's messages on many ports, in the caller's thread, without liblcm: every datagram is
// checked (lib/bus/bus/lcm_assembler.h), and the kernel throws away what was not subscribed to
// (lib/bus/bus/channel_filter.h).
//
//   LcmReceiver receiver;
//   receiver.Listen(7667, "NAV_ALPHA");
//   while (true) receiver.Poll(100'000, -1, [](int port, auto channel, auto data) { ... });
#pragma once

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/uio.h>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/lcm_assembler.h"

namespace shoal {

/// Where datagrams of other channels are thrown away. The kernel counts them among those that found
/// a full receive buffer (lib/bus/bus/socket_drops.h): kProcess, where that count is wanted.
enum class FilterPlace { kKernel, kProcess };

/// What Poll wakes up for.
enum class WakeFor {
  kAll,   ///< Datagrams of every port.
  kSteps  ///< Those of the ports before the first that is deferred; the others keep theirs.
};

class LcmReceiver {
 public:
  /// `data`: the message, with its seal where it has one (lib/bus/bus/seal.h).
  using Handler =
      std::function<void(int port, std::string_view channel, std::span<const uint8_t> data)>;

  explicit LcmReceiver(FilterPlace place = FilterPlace::kKernel);
  ~LcmReceiver();
  LcmReceiver(const LcmReceiver&) = delete;
  LcmReceiver& operator=(const LcmReceiver&) = delete;

  void Listen(int port, std::string_view channel);
  void ListenToAll(int port);

  /// Ports from this on are deferred: a Poll can do without waking up for them, and reads them
  /// before the others.
  void DeferFrom(int port);

  /// Waits at most `timeout_us` for datagrams (or for `extra_fd` to be readable, if not negative),
  /// then hands all that are there to `handler`, of every port, or some ten thousand. Returns true
  /// where `extra_fd` is readable.
  bool Poll(int64_t timeout_us, int extra_fd, const Handler& handler,
            WakeFor wake_for = WakeFor::kAll);
  /// True where the last Poll left datagrams for the next: a flood must not starve its caller.
  bool has_more() const { return has_more_; }
  /// Makes the running Poll return, and leave the rest for the next. Called by the handler.
  void EndPoll() { ends_poll_ = true; }

  /// Has arrived_utime() state when the datagram that the handler is given reached this machine's
  /// socket: microseconds since 1970.
  void StampArrivals();
  int64_t arrived_utime() const { return arrived_utime_; }

  /// Datagrams that are none of LCM's, and messages of which a part did not come. (The kernel
  /// throws away most of the first, uncounted.)
  int64_t num_refused() const { return assembler_.num_malformed() + assembler_.num_abandoned(); }

  /// A descriptor that is readable where Poll has something to read, for callers with a poll of
  /// their own. Poll must have been called since the last Listen.
  int fd() const { return epoll_; }

  /// Empty, or why a port could not be opened, with what to try.
  const std::string& error() const { return error_; }

 private:
  struct Port {
    int number = 0;
    int socket = -1;
    std::set<std::string, std::less<>> channels;
    bool takes_all = false;
    bool has_new_filter = false;  ///< To be given to the kernel.
  };
  static constexpr size_t kBatch = 32;
  static constexpr size_t kLargest = 65536;
  static constexpr size_t kControlSize = 64;

  Port* Open(int port);
  void Close(Port* port, const std::string& why);
  void SetFilters();
  /// Reads a batch from the port. Returns how many datagrams came.
  size_t Read(const Port* port);
  /// Hands what was read to the handler, up to EndPoll.
  void Handle(const Handler& handler);

  const FilterPlace place_;
  int epoll_ = -1;        ///< Of all ports.
  int steps_epoll_ = -1;  ///< Of those that are not deferred.
  int deferred_from_ = std::numeric_limits<int>::max();
  std::vector<std::unique_ptr<Port>> ports_;
  LcmAssembler assembler_;
  std::string error_;
  bool stamps_ = false;
  bool has_new_filters_ = false;
  bool has_more_ = false;
  bool ends_poll_ = false;
  int64_t arrived_utime_ = 0;

  // The batch that is being handled.
  const Port* batch_port_ = nullptr;
  size_t batch_size_ = 0;
  size_t batch_next_ = 0;
  std::vector<uint8_t> bytes_;
  std::array<iovec, kBatch> places_{};
  std::array<mmsghdr, kBatch> headers_{};
  std::array<sockaddr_in, kBatch> senders_{};
  struct alignas(cmsghdr) Control {
    std::array<uint8_t, kControlSize> bytes;
  };
  std::array<Control, kBatch> controls_{};
};

}  // namespace shoal
