#include "tests/missions/delaying_proxy.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <deque>
#include <list>
#include <string>
#include <thread>
#include <vector>

#include "lib/bus/os/file_descriptor.h"

namespace shoal {

namespace {

double SteadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

struct DelayingProxy::State {
  /// One direction of a connection.
  struct Way {
    int from = -1;
    int to = -1;
    struct Piece {
      double due_s;
      std::string bytes;
    };
    std::deque<Piece> pieces = {};
  };

  FileDescriptor listener;
  int target_port = 0;
  double delay_s = 0;
  std::list<std::array<FileDescriptor, 2>> sockets;
  std::list<Way> ways;
  std::atomic<bool> stops = false;
  std::atomic<bool> stalls = false;
  std::thread thread;

  void Accept();
  void Read(Way* way) const;
  void Run();
};

void DelayingProxy::State::Accept() {
  FileDescriptor here(accept4(listener.get(), nullptr, nullptr, SOCK_CLOEXEC));
  if (!here.is_open()) return;
  FileDescriptor there(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(target_port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(there.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) return;
  constexpr int kOn = 1;
  for (const int each : {here.get(), there.get()}) {
    setsockopt(each, IPPROTO_TCP, TCP_NODELAY, &kOn, sizeof kOn);
  }
  ways.push_back({.from = here.get(), .to = there.get()});
  ways.push_back({.from = there.get(), .to = here.get()});
  sockets.push_back({std::move(here), std::move(there)});
}

void DelayingProxy::State::Read(Way* way) const {
  std::array<char, 65536> bytes{};
  const ssize_t size = recv(way->from, bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (size > 0) {
    way->pieces.push_back(
        {SteadySeconds() + delay_s, std::string(bytes.data(), static_cast<size_t>(size))});
  } else if (size == 0) {
    shutdown(way->to, SHUT_RDWR);
    shutdown(way->from, SHUT_RDWR);
    way->from = -1;
  }
}

void DelayingProxy::State::Run() {
  while (!stops) {
    if (stalls) {
      usleep(10'000);
      continue;
    }
    std::vector<pollfd> waited = {{.fd = listener.get(), .events = POLLIN, .revents = 0}};
    double next_s = SteadySeconds() + 0.05;
    for (const Way& way : ways) {
      waited.push_back({.fd = way.from, .events = POLLIN, .revents = 0});
      if (!way.pieces.empty()) next_s = std::min(next_s, way.pieces.front().due_s);
    }
    const double wait_s = std::max(0.0, next_s - SteadySeconds());
    timespec timeout{.tv_sec = 0, .tv_nsec = std::lround(wait_s * 1e9)};
    ppoll(waited.data(), waited.size(), &timeout, nullptr);
    for (Way& way : ways) {
      if (way.from >= 0) Read(&way);
      while (!way.pieces.empty() && way.pieces.front().due_s <= SteadySeconds()) {
        const std::string& bytes = way.pieces.front().bytes;
        send(way.to, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        way.pieces.pop_front();
      }
    }
    if ((waited[0].revents & POLLIN) != 0) Accept();
  }
}

DelayingProxy::DelayingProxy(int target_port, double delay_s) : state_(std::make_unique<State>()) {
  state_->target_port = target_port;
  state_->delay_s = delay_s;
  state_->listener = FileDescriptor(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  constexpr int kWaitingConnections = 5;
  const bool listens =
      bind(state_->listener.get(), reinterpret_cast<sockaddr*>(&address), size) == 0 &&
      listen(state_->listener.get(), kWaitingConnections) == 0 &&
      getsockname(state_->listener.get(), reinterpret_cast<sockaddr*>(&address), &size) == 0;
  if (!listens) return;
  port_ = ntohs(address.sin_port);
  state_->thread = std::thread([this] { state_->Run(); });
}

void DelayingProxy::Stall() { state_->stalls = true; }

DelayingProxy::~DelayingProxy() {
  state_->stops = true;
  if (state_->thread.joinable()) state_->thread.join();
}

}  // namespace shoal
