#include "lib/bus/bus/lcm_receiver.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <linux/filter.h>
#include <poll.h>
#include <sys/epoll.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "lib/bus/bus/channel_filter.h"
#include "lib/bus/bus/layout.h"
#include "lib/bus/bus/multicast_fault.h"

namespace shoal {

namespace {

/// Rounds over the ports in one Poll, a batch from each: a flood must not starve the caller.
constexpr int kMaxRounds = 256;
/// The kernel holds a filter to net.core.optmem_max bytes, some 700 instructions by default. Where
/// it refuses one, a shorter one is tried.
constexpr size_t kMaxInstructions = 700;

int64_t ArrivalOf(const msghdr& header) {
  for (const cmsghdr* each = CMSG_FIRSTHDR(&header); each != nullptr;
       each = CMSG_NXTHDR(const_cast<msghdr*>(&header), const_cast<cmsghdr*>(each))) {
    if (each->cmsg_level != SOL_SOCKET || each->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec arrived{};
    std::memcpy(&arrived, CMSG_DATA(each), sizeof arrived);
    return int64_t{arrived.tv_sec} * 1'000'000 + arrived.tv_nsec / 1000;
  }
  return 0;
}

bool SetOption(int socket, int level, int name, int value) {
  return setsockopt(socket, level, name, &value, sizeof value) == 0;
}

}  // namespace

LcmReceiver::LcmReceiver(FilterPlace place)
    : place_(place),
      epoll_(epoll_create1(EPOLL_CLOEXEC)),
      steps_epoll_(epoll_create1(EPOLL_CLOEXEC)),
      bytes_(kBatch * kLargest) {
  for (size_t i = 0; i < kBatch; ++i) {
    places_[i] = {.iov_base = &bytes_[i * kLargest], .iov_len = kLargest};
    headers_[i].msg_hdr.msg_iov = &places_[i];
    headers_[i].msg_hdr.msg_iovlen = 1;
    headers_[i].msg_hdr.msg_name = &senders_[i];
    headers_[i].msg_hdr.msg_control = controls_[i].bytes.data();
  }
}

LcmReceiver::~LcmReceiver() {
  for (const auto& port : ports_) {
    if (port->socket >= 0) close(port->socket);
  }
  close(epoll_);
  close(steps_epoll_);
}

LcmReceiver::Port* LcmReceiver::Open(int number) {
  const auto found = std::find_if(ports_.begin(), ports_.end(),
                                  [&](const auto& each) { return each->number == number; });
  if (found != ports_.end()) return found->get();
  Port* port = ports_.emplace_back(std::make_unique<Port>()).get();
  port->number = number;
  port->socket = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int opened = port->socket;
  if (opened < 0) {
    Close(port, fmt::format("{}; `ulimit -n` shows how many files a process may open",
                            std::strerror(errno)));
    return port;
  }
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(number));
  // The group's own address: what other machines send to this one's address does not come in.
  address.sin_addr.s_addr = inet_addr(kLcmGroup);
  ip_mreq group{};
  group.imr_multiaddr = address.sin_addr;
  // Beyond the kernel's limit where this process may.
  if (!SetOption(opened, SOL_SOCKET, SO_RCVBUFFORCE, kWantedReceiveBuffer)) {
    SetOption(opened, SOL_SOCKET, SO_RCVBUF, std::min(kWantedReceiveBuffer, ReceiveBufferLimit()));
  }
  if (stamps_) SetOption(opened, SOL_SOCKET, SO_TIMESTAMPNS, 1);
  epoll_event event{.events = EPOLLIN, .data = {.ptr = port}};
  if (!SetOption(opened, SOL_SOCKET, SO_REUSEADDR, 1) ||
      bind(opened, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    Close(port, fmt::format("{}: a program has the port that does not share it. Choose others with "
                            "--port",
                            std::strerror(errno)));
  } else if (setsockopt(opened, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group) != 0 ||
             epoll_ctl(epoll_, EPOLL_CTL_ADD, opened, &event) != 0 ||
             (number < deferred_from_ &&
              epoll_ctl(steps_epoll_, EPOLL_CTL_ADD, opened, &event) != 0)) {
    const std::string fault = MulticastFault();
    Close(port, fault.empty() ? "the group cannot be joined; run `shoal doctor`" : fault);
  }
  return port;
}

void LcmReceiver::Close(Port* port, const std::string& why) {
  if (error_.empty()) error_ = fmt::format("cannot listen on LCM port {}: {}", port->number, why);
  if (port->socket >= 0) close(port->socket);
  port->socket = -1;
}

void LcmReceiver::DeferFrom(int number) {
  deferred_from_ = number;
  for (const auto& port : ports_) {
    if (port->number < number || port->socket < 0) continue;
    epoll_ctl(steps_epoll_, EPOLL_CTL_DEL, port->socket, nullptr);
  }
}

void LcmReceiver::Listen(int port, std::string_view channel) {
  Port* opened = Open(port);
  opened->channels.emplace(channel);
  opened->has_new_filter = has_new_filters_ = true;
}

void LcmReceiver::ListenToAll(int port) {
  Port* opened = Open(port);
  opened->takes_all = true;
  opened->has_new_filter = has_new_filters_ = true;
}

void LcmReceiver::StampArrivals() {
  if (stamps_) return;
  stamps_ = true;
  for (const auto& port : ports_) {
    if (port->socket >= 0) SetOption(port->socket, SOL_SOCKET, SO_TIMESTAMPNS, 1);
  }
}

void LcmReceiver::SetFilters() {
  has_new_filters_ = false;
  for (const auto& port : ports_) {
    if (!port->has_new_filter || port->socket < 0 || place_ == FilterPlace::kProcess) continue;
    port->has_new_filter = false;
    const std::vector<std::string> names(port->channels.begin(), port->channels.end());
    bool is_set = false;
    for (size_t most = kMaxInstructions; !port->takes_all && !is_set && most > 8; most /= 2) {
      std::vector<sock_filter> code = ChannelFilter(names, most);
      if (code.empty()) break;
      const sock_fprog program{.len = static_cast<uint16_t>(code.size()), .filter = code.data()};
      is_set =
          setsockopt(port->socket, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0;
    }
    if (!is_set) SetOption(port->socket, SOL_SOCKET, SO_DETACH_FILTER, 0);
  }
}

bool LcmReceiver::Poll(int64_t timeout_us, int extra_fd, const Handler& handler, WakeFor wake_for) {
  if (has_new_filters_) SetFilters();
  ends_poll_ = false;
  const bool had_rest = batch_next_ < batch_size_;
  Handle(handler);
  if (ends_poll_) {
    has_more_ = true;
    return false;
  }
  timeout_us = had_rest ? 0 : std::max<int64_t>(timeout_us, 0);
  const timespec timeout{.tv_sec = timeout_us / 1'000'000,
                         .tv_nsec = timeout_us % 1'000'000 * 1000};
  const int waited_for = wake_for == WakeFor::kAll ? epoll_ : steps_epoll_;
  std::array<pollfd, 2> waiting{pollfd{.fd = waited_for, .events = POLLIN, .revents = 0},
                                pollfd{.fd = extra_fd, .events = POLLIN, .revents = 0}};
  const bool is_any = ppoll(waiting.data(), extra_fd >= 0 ? 2 : 1, &timeout, nullptr) > 0;
  const bool extra_is_ready = is_any && (waiting[1].revents & POLLIN) != 0;
  has_more_ = is_any && (waiting[0].revents & POLLIN) != 0;
  if (!has_more_) return extra_is_ready;
  std::array<epoll_event, 256> events{};
  const int num = epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), 0);
  auto num_ready = static_cast<size_t>(std::max(num, 0));
  // What a tick announces is there before the tick is handled.
  std::stable_partition(events.begin(), events.begin() + num_ready,
                        [this](const epoll_event& each) {
                          return static_cast<const Port*>(each.data.ptr)->number >= deferred_from_;
                        });
  // Only ports that had a full batch are read again.
  for (int round = 0; round < kMaxRounds && num_ready > 0 && !ends_poll_; ++round) {
    size_t num_full = 0;
    for (size_t i = 0; i < num_ready && !ends_poll_; ++i) {
      const epoll_event event = events[i];
      if (Read(static_cast<const Port*>(event.data.ptr)) == kBatch) events[num_full++] = event;
      Handle(handler);
    }
    num_ready = num_full;
  }
  has_more_ = ends_poll_ || num_ready > 0;
  return extra_is_ready;
}

size_t LcmReceiver::Read(const Port* port) {
  for (mmsghdr& header : headers_) {
    header.msg_hdr.msg_namelen = sizeof(sockaddr_in);
    header.msg_hdr.msg_controllen = stamps_ ? kControlSize : 0;
  }
  const int num = recvmmsg(port->socket, headers_.data(), kBatch, MSG_DONTWAIT, nullptr);
  batch_port_ = port;
  batch_next_ = 0;
  batch_size_ = static_cast<size_t>(std::max(num, 0));
  return batch_size_;
}

void LcmReceiver::Handle(const Handler& handler) {
  while (batch_next_ < batch_size_ && !ends_poll_) {
    const size_t i = batch_next_++;
    const uint64_t sender =
        uint64_t{senders_[i].sin_addr.s_addr} << 16 | uint64_t{senders_[i].sin_port};
    const std::span<const uint8_t> datagram(&bytes_[i * kLargest], headers_[i].msg_len);
    const auto message = assembler_.Add(sender, datagram);
    if (!message) continue;
    if (!batch_port_->takes_all && !batch_port_->channels.contains(message->channel)) continue;
    if (stamps_) arrived_utime_ = ArrivalOf(headers_[i].msg_hdr);
    handler(batch_port_->number, message->channel, message->data);
  }
}

}  // namespace shoal
