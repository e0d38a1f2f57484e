#include "lib/bus/datagram_listener.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <linux/filter.h>
#include <netinet/in.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "lib/bus/layout.h"
#include "lib/check/check.h"

namespace shoal {

namespace {

constexpr size_t kBatch = 32;
/// Rounds over the ports in one Poll, a batch from each: a flood must not starve the caller.
constexpr int kMostRounds = 32;
constexpr size_t kLargest = 65536;
/// Of a message in one datagram: the magic number, a sequence number, the channel, 0, the message.
constexpr std::string_view kLcmMagic = "LC02";
constexpr size_t kHeaderSize = 8;

/// Has the kernel drop what is not of `topics`: the first four bytes of the channel decide.
bool Filter(int opened, std::span<const std::string_view> topics) {
  constexpr uint32_t kUdpHeader = 8;
  std::vector<sock_filter> code = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kUdpHeader + static_cast<uint32_t>(kHeaderSize))};
  for (size_t i = 0; i < topics.size(); ++i) {
    SHOAL_CHECK(topics[i].size() >= 4, "a topic has at least four characters");
    uint32_t word = 0;
    for (const char each : topics[i].substr(0, 4)) word = word << 8 | static_cast<uint8_t>(each);
    // Where it is not this, the next is asked; behind the last stands the refusal.
    const auto to_accept = static_cast<uint8_t>(topics.size() - i);
    code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, word, to_accept, 0));
  }
  code.push_back(BPF_STMT(BPF_RET | BPF_K, 0));
  code.push_back(BPF_STMT(BPF_RET | BPF_K, 0xffffffff));
  const sock_fprog program{.len = static_cast<uint16_t>(code.size()), .filter = code.data()};
  return setsockopt(opened, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof(program)) == 0;
}

}  // namespace

DatagramListener::DatagramListener(std::span<const int> ports,
                                   std::span<const std::string_view> topics)
    : epoll_(epoll_create1(EPOLL_CLOEXEC)), bytes_(kBatch * kLargest) {
  for (const int port : ports) Open(port, topics);
}

DatagramListener::~DatagramListener() {
  for (const int each : sockets_) close(each);
  close(epoll_);
}

void DatagramListener::Open(int port, std::span<const std::string_view> topics) {
  const int opened = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  sockets_.push_back(opened);
  const int yes = 1;
  const int buffer = ReceiveBufferLimit();
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  ip_mreq group{};
  group.imr_multiaddr.s_addr = inet_addr("239.255.76.67");
  epoll_event event{.events = EPOLLIN, .data = {.fd = opened}};
  setsockopt(opened, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof(buffer));
  if ((!topics.empty() && !Filter(opened, topics)) ||
      setsockopt(opened, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes)) != 0 ||
      bind(opened, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
      setsockopt(opened, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof(group)) != 0 ||
      epoll_ctl(epoll_, EPOLL_CTL_ADD, opened, &event) != 0) {
    error_ = fmt::format("cannot listen on port {}: {}", port, std::strerror(errno));
  }
}

void DatagramListener::Poll(
    int timeout_ms,
    const std::function<void(std::string_view, std::span<const uint8_t>)>& handler) {
  std::array<epoll_event, 256> events{};
  int num_ready = epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), timeout_ms);
  for (int round = 0; round < kMostRounds && num_ready > 0; ++round) {
    // Only ports that had a full batch are looked at again.
    int num_full = 0;
    for (int ready = 0; ready < num_ready; ++ready) {
      const epoll_event event = events[static_cast<size_t>(ready)];
      if (Receive(event.data.fd, handler) == static_cast<int>(kBatch)) {
        events[static_cast<size_t>(num_full++)] = event;
      }
    }
    num_ready = num_full;
  }
}

int DatagramListener::Receive(
    int opened, const std::function<void(std::string_view, std::span<const uint8_t>)>& handler) {
  std::array<iovec, kBatch> places{};
  std::array<mmsghdr, kBatch> headers{};
  for (size_t i = 0; i < kBatch; ++i) {
    places[i] = {.iov_base = &bytes_[i * kLargest], .iov_len = kLargest};
    headers[i].msg_hdr.msg_iov = &places[i];
    headers[i].msg_hdr.msg_iovlen = 1;
  }
  const int num = recvmmsg(opened, headers.data(), kBatch, MSG_DONTWAIT, nullptr);
  for (size_t i = 0; num > 0 && i < static_cast<size_t>(num); ++i) {
    const std::string_view text(reinterpret_cast<const char*>(&bytes_[i * kLargest]),
                                headers[i].msg_len);
    const size_t end = text.size() > kHeaderSize ? text.find('\0', kHeaderSize) : text.npos;
    if (!text.starts_with(kLcmMagic) || end == text.npos) continue;
    handler(text.substr(kHeaderSize, end - kHeaderSize),
            std::span(bytes_).subspan(i * kLargest + end + 1, text.size() - end - 1));
  }
  return num;
}

}  // namespace shoal
