// The processes beside the broker when tests/bench/broker measures it: vehicles that report, a
// listener at all receivers, and a relay without rules to compare with.
//
//   broker_load send VEHICLES RATE_HZ WARM_UP_S MEASURED_S PORT:PID...
//   broker_load receive VEHICLES LAYOUT PORT
//   broker_load relay VEHICLES LAYOUT PORT
//
// The vehicles v001, v002, ... stand on a circle of 200 m that turns slowly, and report evenly
// staggered: report k at k / (VEHICLES x RATE_HZ) seconds. With several ports the reports go to
// each in turn, so that what listens there is measured at the same time. PID is whose processor
// time counts. `receive` and `relay` end at SIGTERM. Each prints `key=value` lines; times are
// microseconds.

#include <fmt/format.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <numbers>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/lcm_bus.h"
#include "lib/bus/bus/lcm_receiver.h"
#include "lib/bus/bus/socket_drops.h"
#include "lib/run/run/run_app.h"

namespace shoal {
namespace {

constexpr std::string_view kMeasured = "MODE@ACTIVE:MEASURED";
constexpr std::string_view kWarmUp = "MODE@ACTIVE:WARM_UP";

std::atomic<bool> stop_wanted = false;

std::vector<std::string> Names(int num_vehicles) {
  std::vector<std::string> names;
  for (int i = 1; i <= num_vehicles; ++i) names.push_back(fmt::format("v{:03}", i));
  return names;
}

/// Returns 17 for v017.
size_t NumberOf(std::string_view name) {
  return static_cast<size_t>(std::atoi(std::string(name).c_str() + 1));
}

PortPlan Ports(int num_vehicles, std::string_view layout, int base) {
  return {base, layout == "shared" ? Layout::kShared : Layout::kCommunities, Names(num_vehicles)};
}

/// Returns the processor time that a process has used, all its threads.
double ProcessorSeconds(int pid) {
  std::ifstream in("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  std::getline(in, text);
  std::istringstream fields(text.substr(std::min(text.rfind(')'), text.size() - 1) + 1));
  const std::vector<std::string> words{std::istream_iterator<std::string>(fields), {}};
  constexpr size_t kUser = 11;
  constexpr size_t kSystem = 12;
  if (words.size() <= kSystem) return 0;
  const double ticks = std::atof(words[kUser].c_str()) + std::atof(words[kSystem].c_str());
  return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

void SleepUntil(int64_t monotonic_us) {
  const timespec at{.tv_sec = monotonic_us / 1'000'000, .tv_nsec = monotonic_us % 1'000'000 * 1000};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr);
}

/// An address that is sent to.
struct Target {
  LcmBus bus;
  int pid = 0;
  double processor_s = 0;  ///< At the beginning of what is measured.
};

node_report_t FirstReport(const std::string& name) {
  node_report_t report{};
  report.name = name;
  report.type = "kayak";
  report.color = "yellow";
  report.lat_deg = 43.825300;
  report.lon_deg = -70.330400;
  report.speed_mps = 1.5;
  report.length_m = 4;
  report.all_stop = "clear";
  return report;
}

/// Moves a vehicle along the circle to where it is at this time.
void Place(double begin_rad, double seconds, node_report_t* report) {
  constexpr double kRadius_m = 200;
  constexpr double kTurn_radps = 0.005;
  const double angle_rad = begin_rad + kTurn_radps * seconds;
  report->x_m = kRadius_m * std::sin(angle_rad);
  report->y_m = kRadius_m * std::cos(angle_rad);
  report->heading_deg = std::fmod(angle_rad * 180 / std::numbers::pi + 90, 360);
}

int Send(int num_vehicles, double rate_hz, double warm_up_s, double measured_s,
         const std::vector<std::string>& where) {
  std::vector<std::unique_ptr<Target>> targets;
  for (const std::string& each : where) {
    const int port = std::atoi(each.c_str());
    const int pid = std::atoi(each.substr(each.find(':') + 1).c_str());
    targets.push_back(
        std::unique_ptr<Target>(new Target{.bus = LcmBus(Ports(0, "shared", port)), .pid = pid}));
  }
  std::vector<node_report_t> reports;
  for (const std::string& name : Names(num_vehicles)) reports.push_back(FirstReport(name));

  const double per_second = num_vehicles * rate_hz * static_cast<double>(targets.size());
  const auto num_warm_up = std::llround(warm_up_s * per_second);
  const auto num_all = std::llround((warm_up_s + measured_s) * per_second);
  const Channel<node_report_t> channel = channels::NodeReportLocal();
  const int64_t begin_us = MonotonicMicroseconds();
  int64_t measured_from_us = begin_us;
  for (int64_t k = 0; k < num_all; ++k) {
    const double at_s = static_cast<double>(k) / per_second;
    const auto due_us = begin_us + std::llround(at_s * 1e6);
    if (MonotonicMicroseconds() < due_us) SleepUntil(due_us);
    if (k == num_warm_up) {
      measured_from_us = MonotonicMicroseconds();
      for (const auto& target : targets) target->processor_s = ProcessorSeconds(target->pid);
    }
    const auto num_targets = static_cast<int64_t>(targets.size());
    const int64_t round = k / num_targets;
    const int64_t vehicle = round % num_vehicles;
    node_report_t& report = reports[static_cast<size_t>(vehicle)];
    report.index = round / num_vehicles;
    report.mode = k < num_warm_up ? kWarmUp : kMeasured;
    Place(2 * std::numbers::pi * static_cast<double>(vehicle) / num_vehicles, at_s, &report);
    report.utime = MonotonicMicroseconds();
    Publish(targets[static_cast<size_t>(k % num_targets)]->bus, channel, report);
  }
  const double elapsed_s = static_cast<double>(MonotonicMicroseconds() - measured_from_us) / 1e6;
  for (const auto& target : targets) {
    fmt::print("sent_all={}\nsent={}\nseconds={:.3f}\ncpu={:.2f}\n",
               target->bus.counters().published,
               (num_all - num_warm_up) / static_cast<int64_t>(targets.size()), elapsed_s,
               (ProcessorSeconds(target->pid) - target->processor_s) / elapsed_s);
  }
  return 0;
}

/// What arrived of one vehicle's reports at one receiver.
struct Pair {
  int64_t count = 0;
  int64_t first_index = -1;
  int64_t last_index = -1;
  int64_t out_of_order = 0;
};

int Receive(const PortPlan& ports, int num_vehicles) {
  const auto num = static_cast<size_t>(num_vehicles);
  std::vector<Pair> pairs(num * num);
  std::vector<int64_t> latencies_us;
  latencies_us.reserve(4'000'000);
  // In the shared layout all deliveries come on the shore's port, else on the communities'.
  const std::vector<int> all = ports.DataPorts();
  LcmReceiver listener(FilterPlace::kProcess);
  for (const int port : std::span<const int>(all).subspan(all.size() > 1 ? 1 : 0)) {
    listener.ListenToAll(port);
  }
  if (!listener.error().empty()) {
    fmt::print(stderr, "broker_load: {}\n", listener.error());
    return 3;
  }
  fmt::print("ready\n");
  std::fflush(stdout);
  node_report_t report;
  while (!stop_wanted) {
    listener.Poll(100'000, -1,
                  [&](int, std::string_view channel, std::span<const uint8_t> message) {
                    const int64_t now_us = MonotonicMicroseconds();
                    constexpr std::string_view kPrefix = "NODE_REPORT_V";
                    if (!channel.starts_with(kPrefix) || !Decode(message, &report)) return;
                    if (report.mode != kMeasured) return;
                    const size_t source = NumberOf(report.name) - 1;
                    const size_t receiver = NumberOf(channel.substr(kPrefix.size() - 1)) - 1;
                    if (source >= num || receiver >= num) return;
                    latencies_us.push_back(now_us - report.utime);
                    Pair& pair = pairs[receiver * num + source];
                    ++pair.count;
                    if (pair.first_index < 0) pair.first_index = report.index;
                    if (report.index <= pair.last_index) ++pair.out_of_order;
                    pair.last_index = std::max(pair.last_index, report.index);
                  });
  }

  Pair sum;
  int64_t gaps = 0;
  for (const Pair& pair : pairs) {
    sum.count += pair.count;
    sum.out_of_order += pair.out_of_order;
    if (pair.count > 0) gaps += pair.last_index - pair.first_index + 1 - pair.count;
  }
  std::sort(latencies_us.begin(), latencies_us.end());
  const auto quantile = [&](double share) {
    if (latencies_us.empty()) return int64_t{-1};
    const auto last = static_cast<double>(latencies_us.size() - 1);
    return latencies_us[static_cast<size_t>(share * last)];
  };
  fmt::print(
      "delivered={}\ngaps={}\nout_of_order={}\nkernel_lost={}\np50={}\np99={}\nmax={}\n"
      "receiver_cpu_s={:.2f}\n",
      sum.count, gaps, sum.out_of_order, DroppedDatagrams(ports.DataPorts()), quantile(0.5),
      quantile(0.99), quantile(1), ProcessorSeconds(getpid()));
  return 0;
}

/// Hands each report to every other vehicle at once, without decoding it.
int Relay(const PortPlan& ports, int num_vehicles) {
  std::vector<std::string> receivers;
  for (const std::string& name : Names(num_vehicles)) {
    receivers.push_back(channels::NodeReport(name).name);
  }
  LcmBus bus(ports);
  node_report_t report;
  bus.SubscribeBytes(channels::NodeReportLocal().name, [&](const Message& message) {
    if (!Decode(message.data, &report)) return;
    const size_t source = NumberOf(report.name) - 1;
    for (size_t i = 0; i < receivers.size(); ++i) {
      if (i != source) bus.PublishBytes(receivers[i], message.data);
    }
  });
  if (!bus.error().empty()) {
    fmt::print(stderr, "broker_load: {}\n", bus.error());
    return 3;
  }
  fmt::print("ready\n");
  std::fflush(stdout);
  while (!stop_wanted) bus.Poll(100'000);
  return 0;
}

int Main(const std::vector<std::string>& arguments) {
  struct sigaction action {};
  action.sa_handler = [](int) { stop_wanted = true; };
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
  const std::string what = arguments.empty() ? "" : arguments[0];
  const int num_vehicles = arguments.size() > 1 ? std::atoi(arguments[1].c_str()) : 0;
  if (num_vehicles > 0 && num_vehicles < 1000) {
    if (what == "send" && arguments.size() > 5) {
      return Send(num_vehicles, std::atof(arguments[2].c_str()), std::atof(arguments[3].c_str()),
                  std::atof(arguments[4].c_str()), {arguments.begin() + 5, arguments.end()});
    }
    if (arguments.size() == 4) {
      const PortPlan ports = Ports(num_vehicles, arguments[2], std::atoi(arguments[3].c_str()));
      if (what == "receive") return Receive(ports, num_vehicles);
      if (what == "relay") return Relay(ports, num_vehicles);
    }
  }
  fmt::print(stderr, "usage: see the beginning of tests/bench/broker_load.cc\n");
  return 2;
}

}  // namespace
}  // namespace shoal

int main(int argc, char** argv) { return shoal::Main({argv + 1, argv + argc}); }
