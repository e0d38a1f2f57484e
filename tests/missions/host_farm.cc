#include "tests/missions/host_farm.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <deque>
#include <list>
#include <thread>

#include "lib/record/file_descriptor.h"

namespace shoal {

namespace {

std::string MakeKey(const TestFolder& folder, const std::string& name) {
  const std::string prefix = (folder / name).string();
  const Finished made = RunShoal(folder, {"host", "keygen", "--out", prefix});
  EXPECT_EQ(made.exit_code, 0) << made.output;
  return prefix;
}

}  // namespace

HostFarm::HostFarm(size_t count, std::vector<std::string> options) {
  home_key = MakeKey(folder, "home");
  const int port = FreeTcpPorts(static_cast<int>(count));
  for (size_t i = 0; i < count; ++i) {
    const std::string name = "host" + std::to_string(i + 1);
    hosts.push_back({.name = name,
                     .address = "tcp://127.0.0.1:" + std::to_string(port + static_cast<int>(i)),
                     .public_key_file = MakeKey(folder, name) + ".pub",
                     .process = nullptr});
    Start(i, options);
  }
}

void HostFarm::Start(size_t host, const std::vector<std::string>& options) {
  TestHost& each = hosts[host];
  std::vector<std::string> argv = {Program("shoal"), "host",
                                   "--listen",       each.address,
                                   "--key",          (folder / (each.name + ".key")).string(),
                                   "--allow",        home_key + ".pub"};
  argv.insert(argv.end(), options.begin(), options.end());
  each.process.reset();
  each.process = std::make_unique<RunningProcess>(folder, argv);
  ASSERT_TRUE(each.process->WaitFor("shoal host listens")) << each.process->Output();
}

std::string HostFarm::Placed(const std::string& mission, const std::vector<std::string>& vehicles,
                             const std::string& more, std::vector<std::string> addresses) {
  std::string text = ReadFile(MissionFile(mission));
  for (size_t i = 0; i < vehicles.size(); ++i) {
    const bool is_given = i < addresses.size() && !addresses[i].empty();
    text += "\n[[host]]\nname = \"" + hosts[i].name + "\"\naddress = \"" +
            (is_given ? addresses[i] : hosts[i].address) + "\"\nkey = \"" + hosts[i].name +
            ".pub\"\nvehicles = [" + vehicles[i] + "]\n" + more;
  }
  const std::string path = (folder / mission).string();
  WriteFile(path, text);
  CopyMissionData(folder.path());
  return path;
}

std::vector<std::string> HostFarm::RunCommand(const std::string& mission_file,
                                              const std::vector<std::string>& more) const {
  std::vector<std::string> argv = {Program("shoal"), "run", mission_file, "--warp", "max", "--key",
                                   home_key + ".key"};
  argv.insert(argv.end(), more.begin(), more.end());
  return argv;
}

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
        {WallSeconds() + delay_s, std::string(bytes.data(), static_cast<size_t>(size))});
  } else if (size == 0) {
    shutdown(way->to, SHUT_RDWR);
    shutdown(way->from, SHUT_RDWR);
    way->from = -1;
  }
}

void DelayingProxy::State::Run() {
  while (!stops) {
    std::vector<pollfd> waited = {{.fd = listener.get(), .events = POLLIN, .revents = 0}};
    double next_s = WallSeconds() + 0.05;
    for (const Way& way : ways) {
      waited.push_back({.fd = way.from, .events = POLLIN, .revents = 0});
      if (!way.pieces.empty()) next_s = std::min(next_s, way.pieces.front().due_s);
    }
    const double wait_s = std::max(0.0, next_s - WallSeconds());
    timespec timeout{.tv_sec = 0, .tv_nsec = std::lround(wait_s * 1e9)};
    ppoll(waited.data(), waited.size(), &timeout, nullptr);
    for (Way& way : ways) {
      if (way.from >= 0) Read(&way);
      while (!way.pieces.empty() && way.pieces.front().due_s <= WallSeconds()) {
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
  bind(state_->listener.get(), reinterpret_cast<sockaddr*>(&address), size);
  listen(state_->listener.get(), 5);
  getsockname(state_->listener.get(), reinterpret_cast<sockaddr*>(&address), &size);
  port_ = ntohs(address.sin_port);
  state_->thread = std::thread([this] { state_->Run(); });
}

DelayingProxy::~DelayingProxy() {
  state_->stops = true;
  state_->thread.join();
}

}  // namespace shoal
