// How long netsim's clients wait for their answers: 8 of them, 1,000 positions per second together,
// from a process that also waits for LCM; then with 200 others that behave badly.
//
//   netsim_bench [seconds]
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "lib/bus/bus/lcm_transport.h"
#include "lib/mission/netsim/line_server.h"
#include "lib/mission/netsim/netsim_answer.h"
#include "lib/mission/netsim/netsim_testing.h"
#include "tests/netsim/rude_clients.h"
#include "tests/netsim/tcp_client.h"

namespace shoal {
namespace {

constexpr int kNumClients = 8;
constexpr int kNumRude = 200;
constexpr int64_t kInterval_us = 8'000;  ///< Of each client: 1,000 per second together.
constexpr int kLcmPort = 18'990;

int64_t Now_us() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// netsim's documented example; its place is refused only after all was looked at.
const std::string kRequest =
    "NETSIM|netsim.protobuf.NetSimManagerRequest|"
    "CEISOgiw5AMRQ4tUIbbq10EZQUDRT0vLUUAhQylH7tbMYcApMzMzMzMz0z8x65lyHNEpUj85AAAAAAAALkA=\n";

/// What netsim_manager's loop is: LCM and clients in one thread.
void Serve(LineServer* server, const std::atomic<bool>& stopped) {
  LcmTransport transport;
  int64_t num_received = 0;
  transport.set_receiver([&](int, std::string_view, std::span<const uint8_t>) { ++num_received; });
  transport.ListenToAll(kLcmPort);
  if (!transport.error().empty()) fmt::print(stderr, "{}\n", transport.error());
  while (!stopped) {
    transport.Poll(100'000, server->fd());
    server->Serve(Now_us());
  }
}

struct Waits {
  std::vector<int64_t> answered_us = {};
  int64_t num_unanswered = 0;
};

/// One client: a request each interval, the next one when the answer is there.
Waits Request(int port, int64_t seconds) {
  Waits waits;
  TcpClient client(port);
  size_t num_expected_bytes = 0;
  const int64_t begin_us = Now_us();
  for (int64_t i = 0; i * kInterval_us < seconds * 1'000'000; ++i) {
    const int64_t due_us = begin_us + i * kInterval_us;
    std::this_thread::sleep_for(std::chrono::microseconds(due_us - Now_us()));
    const int64_t sent_us = Now_us();
    client.Send(kRequest);
    num_expected_bytes += 54;
    while (client.received().size() < num_expected_bytes && Now_us() - sent_us < 1'000'000) {
      pollfd waited{.fd = client.fd(), .events = POLLIN, .revents = 0};
      poll(&waited, 1, 100);
      client.Receive();
    }
    if (client.received().size() == num_expected_bytes) {
      waits.answered_us.push_back(Now_us() - sent_us);
    } else {
      ++waits.num_unanswered;
    }
  }
  return waits;
}

void Measure(const char* what, int port, int64_t seconds) {
  std::vector<Waits> each(kNumClients);
  {
    std::vector<std::jthread> clients;
    for (Waits& waits : each) {
      clients.emplace_back([&waits, port, seconds] { waits = Request(port, seconds); });
    }
  }
  std::vector<int64_t> all_us;
  int64_t num_unanswered = 0;
  for (const Waits& waits : each) {
    all_us.insert(all_us.end(), waits.answered_us.begin(), waits.answered_us.end());
    num_unanswered += waits.num_unanswered;
  }
  std::sort(all_us.begin(), all_us.end());
  const auto quantile_ms = [&](double part) {
    if (all_us.empty()) return 0.0;
    const auto last = static_cast<double>(all_us.size() - 1);
    return static_cast<double>(all_us[static_cast<size_t>(part * last)]) / 1000;
  };
  fmt::print(
      "{}: {} answers in {} s, {} missing; median {:.3f} ms, 99% {:.3f} ms, longest {:.3f} "
      "ms\n",
      what, all_us.size(), seconds, num_unanswered, quantile_ms(0.5), quantile_ms(0.99),
      quantile_ms(1));
}

int Run(int64_t seconds) {
  NetsimOptions options = TwoNetsimVehicles();
  auto server = LineServer::Listen({.max_connections = kNumClients + kNumRude}, 4096,
                                   [&](const std::string& address, std::string_view line) {
                                     return AnswerLine(line, address, options).answer;
                                   });
  if (!server.ok()) {
    fmt::print(stderr, "{}\n", server.error());
    return kExitEnvironment;
  }
  const int port = (*server)->port();
  std::atomic<bool> stopped = false;
  std::jthread serving([&] { Serve(server->get(), stopped); });
  Measure("8 clients", port, seconds);
  {
    std::jthread rude([&](std::stop_token token) {
      RudeClients crowd(port, kNumRude, 7, kRequest);
      while (!token.stop_requested()) {
        for (int i = 0; i < 5; ++i) crowd.Act();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
    Measure("8 clients among 200 rude ones", port, seconds);
  }
  stopped = true;
  return kExitOk;
}

}  // namespace
}  // namespace shoal

int main(int argc, char** argv) { return shoal::Run(argc > 1 ? std::atoll(argv[1]) : 5); }
