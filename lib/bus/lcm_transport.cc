#include "lib/bus/lcm_transport.h"

#include <fmt/format.h>
#include <poll.h>
#include <time.h>

#include <algorithm>

#include "lib/bus/layout.h"

namespace shoal {

namespace {

/// LCM takes channel names as regular expressions, "^name$".
std::string EscapeRegex(std::string_view channel) {
  std::string out;
  for (const char c : channel) {
    if (std::string_view(".\\+*?[^]$(){}=!<>|:-#").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

}  // namespace

struct LcmTransport::Port {
  LcmTransport* owner = nullptr;
  int number = 0;
  lcm_t* lcm = nullptr;
  bool listens = false;
};

LcmTransport::LcmTransport() = default;

LcmTransport::~LcmTransport() {
  for (const auto& port : ports_) {
    if (port->lcm != nullptr) lcm_destroy(port->lcm);
  }
}

LcmTransport::Port* LcmTransport::Open(int port) {
  const auto at = std::lower_bound(
      ports_.begin(), ports_.end(), port,
      [](const std::unique_ptr<Port>& each, int number) { return each->number < number; });
  if (at != ports_.end() && (*at)->number == port) return at->get();
  auto opened = std::make_unique<Port>();
  opened->owner = this;
  opened->number = port;
  opened->lcm = lcm_create(LcmUrl(port).c_str());
  if (opened->lcm == nullptr && error_.empty()) {
    error_ = fmt::format(
        "cannot open LCM port {}: multicast does not work on this machine. Run `shoal doctor`; "
        "most often this helps: sudo ip link set lo up multicast on && sudo ip route add "
        "224.0.0.0/4 dev lo",
        port);
  }
  return ports_.insert(at, std::move(opened))->get();
}

void LcmTransport::Send(int port, std::string_view channel, std::span<const uint8_t> datagram) {
  const Port* opened = Open(port);
  // What fails here is lost like any datagram: the step protocol asks for it again, or gives up.
  const bool is_sent = opened->lcm != nullptr &&
                       lcm_publish(opened->lcm, std::string(channel).c_str(), datagram.data(),
                                   static_cast<unsigned>(datagram.size())) == 0;
  if (!is_sent) ++num_failed_sends_;
}

void LcmTransport::Subscribe(int port, const std::string& regex) {
  Port* opened = Open(port);
  if (opened->lcm == nullptr) return;
  lcm_subscription_t* subscription =
      lcm_subscribe(opened->lcm, regex.c_str(), &LcmTransport::OnLcmMessage, opened);
  if (subscription == nullptr) {
    if (error_.empty()) {
      error_ = fmt::format(
          "cannot listen on LCM port {}: the port is taken by a program that does not share it, or "
          "multicast does not work. Run `shoal doctor`, or choose other ports with --port",
          port);
    }
    return;
  }
  lcm_subscription_set_queue_capacity(subscription, 0);  // 0: no limit; LCM's default is 30
  opened->listens = true;
}

void LcmTransport::Listen(int port, const std::string& channel) {
  Subscribe(port, EscapeRegex(channel));
}

void LcmTransport::ListenToAll(int port) { Subscribe(port, ".*"); }

void LcmTransport::OnLcmMessage(const lcm_recv_buf_t* buffer, const char* channel, void* user) {
  const Port* port = static_cast<Port*>(user);
  const std::string_view name(channel);
  if (name == "LCM_SELF_TEST") return;
  LcmTransport& self = *port->owner;
  if (self.drop_ && self.drop_(name)) return;
  self.arrived_utime_ = buffer->recv_utime;
  self.receiver_(port->number, name,
                 {static_cast<const uint8_t*>(buffer->data), buffer->data_size});
}

bool LcmTransport::Poll(int64_t timeout_us, int extra_fd) {
  descriptors_.clear();
  listening_.clear();
  for (const auto& port : ports_) {
    if (!port->listens) continue;
    descriptors_.push_back({.fd = lcm_get_fileno(port->lcm), .events = POLLIN, .revents = 0});
    listening_.push_back(port.get());
  }
  if (extra_fd >= 0) descriptors_.push_back({.fd = extra_fd, .events = POLLIN, .revents = 0});
  timeout_us = std::max<int64_t>(timeout_us, 0);
  timespec timeout{.tv_sec = timeout_us / 1'000'000, .tv_nsec = timeout_us % 1'000'000 * 1000};
  bool extra_is_ready = false;
  // Once more with no wait after each round, until nothing is left, or a flood must not starve the
  // caller's clock any longer.
  constexpr int kMaxRounds = 2000;
  has_more_ = true;
  ends_poll_ = false;
  for (int round = 0; round < kMaxRounds && !ends_poll_; ++round) {
    bool handled = false;
    if (ppoll(descriptors_.data(), descriptors_.size(), &timeout, nullptr) > 0) {
      for (size_t i = 0; i < listening_.size(); ++i) {
        if ((descriptors_[i].revents & POLLIN) == 0) continue;
        lcm_handle(listening_[i]->lcm);
        handled = true;
      }
      if (extra_fd >= 0 && (descriptors_.back().revents & POLLIN) != 0) extra_is_ready = true;
    }
    if (!handled) {
      has_more_ = false;
      break;
    }
    timeout = {.tv_sec = 0, .tv_nsec = 0};
  }
  return extra_is_ready;
}

}  // namespace shoal
