#include "lib/run/run/live.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/lcm_bus.h"
#include "lib/bus/bus/multicast_fault.h"
#include "lib/bus/bus/socket_drops.h"
#include "lib/run/run/appcast.h"
#include "lib/run/run/roster.h"
#include "lib/run/run/round_size.h"
#include "lib/run/run/run_app.h"
#include "lib/run/run/run_registry.h"

namespace shoal {

namespace {

constexpr int kUsefulReceiveBuffer = 4'194'304;  ///< Bytes; more is not asked for.

/// The app's page, with what became of messages before they reached it.
StatusPage PageWithLosses(const App& app, const LcmBus& bus, const PortPlan& ports) {
  StatusPage page = app.Status();
  const BusCounters& counters = bus.counters();
  const int64_t dropped = DroppedDatagrams(ports.DataPorts());
  if (counters.overload > 0) {
    page.run_warnings.push_back(
        fmt::format("overload: {} messages dropped that had waited for more than {} ms",
                    counters.overload, kLongestWait_us / 1000));
  }
  if (dropped > 0) {
    const std::string remedy =
        ReceiveBufferLimit() < kUsefulReceiveBuffer
            ? fmt::format("sudo sysctl -w net.core.rmem_max={} helps", kUsefulReceiveBuffer)
            : std::string("it is as large as is of use: fewer messages, or other ports for some");
    page.run_warnings.push_back(
        fmt::format("{} datagrams were lost before they were read: receive buffer full ({}; now "
                    "{} bytes)",
                    dropped, remedy, ReceiveBufferLimit()));
  }
  if (bus.num_failed_sends() > 0) {
    page.run_warnings.push_back(
        fmt::format("{} messages could not be sent{}", bus.num_failed_sends(),
                    bus.error().empty() ? std::string() : ": " + bus.error()));
  }
  for (const auto& [channel, count] : counters.undecodable_by_channel) {
    page.run_warnings.push_back(fmt::format("{} undecodable messages on {}", count, channel));
  }
  page.text += fmt::format(
      "\nBus: {} published, {} handled, {} undecodable, {} dropped in overload, {} datagrams lost "
      "in the kernel\n",
      counters.published, counters.handled, counters.undecodable, counters.overload, dropped);
  return page;
}

/// An entry among the running missions, for as long as it lives.
class Registration {
 public:
  explicit Registration(const RunningMission& mission)
      : port_base_(mission.port_base), result_(Register(mission)) {}
  ~Registration() { Unregister(port_base_); }
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;

  const Result<bool>& result() const { return result_; }

 private:
  int port_base_;
  Result<bool> result_;
};

}  // namespace

int RunLive(const LiveOptions& options, Mission mission,
            const std::function<std::unique_ptr<App>(const Mission&, Bus&)>& make) {
  const auto fail = [&](const std::string& why) {
    fmt::print(stderr, "{}: {}\n", options.name, why);
    return static_cast<int>(kExitEnvironment);
  };
  if (const std::string fault = MulticastFault(); !fault.empty()) return fail(fault);
  const Result<std::vector<RunningMission>> others = RunningMissions();
  if (!others.ok()) return fail(others.error());
  for (const RunningMission& other : *others) {
    const PortPlan& ours = options.ports;
    const PortPlan theirs = other.Ports();
    if (theirs.base() < ours.base() + ours.num_ports() &&
        ours.base() < theirs.base() + theirs.num_ports()) {
      return fail(fmt::format("{} (pid {}) has ports {} to {} already; choose others with --port",
                              other.name, other.pid, theirs.base(),
                              theirs.base() + theirs.num_ports() - 1));
    }
  }
  const Registration registration(
      {.name = mission.name,
       .file = std::filesystem::absolute(mission.file).lexically_normal().string(),
       .folder = WorkingFolder(),
       .mission_id = 0,
       .port_base = options.ports.base(),
       .layout = options.ports.layout(),
       .pid = static_cast<int>(getpid()),
       .vehicles = VehicleNames(mission)});
  if (!registration.result().ok()) return fail(registration.result().error());

  const int64_t begin_us = MonotonicMicroseconds();
  mission.start_utime = UnixMicroseconds();
  const auto utime = [&] { return mission.start_utime + MonotonicMicroseconds() - begin_us; };

  LcmBus bus(options.ports, FilterPlace::kProcess);  // Its page counts what the kernel dropped.
  RoundSize round_size;
  const std::unique_ptr<App> app = make(mission, bus);
  app->OnWarp(1);
  int64_t num_rounds = 0;
  const auto page = [&] { return PageWithLosses(*app, bus, options.ports); };
  bool is_asked = false;
  Subscribe(bus, channels::AppcastReq(), [&](const appcast_req_t& request) {
    is_asked = is_asked || request.app == "all" || request.app == options.name;
  });
  std::vector<App::RequestAnswer> answers;
  for (const std::string& channel : app->RequestChannels()) {
    bus.SubscribeBytes(channel, [&](const Message& message) {
      if (auto answer = app->Answer(message.channel, message.data)) {
        answers.clear();
        answers.push_back(std::move(*answer));
      }
    });
  }
  if (!bus.error().empty()) return fail(bus.error());
  app->Tick(mission.start_utime);  // Its first step is the mission's first: it has missed nothing.
  fmt::print("{}: live on {}; Ctrl-C ends\n", options.name, LcmUrl(options.ports.shore_port()));
  std::fflush(stdout);

  const bool on_terminal = isatty(STDOUT_FILENO) == 1;
  int64_t next_tick_us = begin_us;
  int64_t next_show_us = begin_us;
  int64_t last_spent_us = ProcessorMicroseconds();
  while (!options.stopped()) {
    const int64_t handled_before = bus.counters().handled;
    bus.set_limits(
        {.most = round_size.most(), .oldest_utime = UnixMicroseconds() - kLongestWait_us});
    bus.Poll(std::max<int64_t>(next_tick_us - MonotonicMicroseconds(), 0));
    app->Tick(utime());
    const int64_t spent_us = ProcessorMicroseconds();
    round_size.AfterRound(bus.counters().handled - handled_before, spent_us - last_spent_us);
    last_spent_us = spent_us;
    ++num_rounds;
    const int64_t now_us = MonotonicMicroseconds();
    next_tick_us = now_us + options.tick_us;
    if (is_asked)
      Publish(bus, channels::Appcast(), ToAppcast(page(), options.name, utime(), num_rounds));
    is_asked = false;
    for (const App::RequestAnswer& answer : answers) bus.PublishBytes(answer.channel, answer.data);
    answers.clear();
    if (on_terminal && now_us >= next_show_us) {
      fmt::print("\033[2J\033[H{}", Format(page(), options.name, num_rounds));
      std::fflush(stdout);
      next_show_us = now_us + kTerminalInterval_us;
    }
    if (const std::string fault = app->Fault(); !fault.empty()) return fail(fault);
  }
  app->End();
  fmt::print("{}\n{}: ended by a signal\n", Format(page(), options.name, num_rounds), options.name);
  return kExitOk;
}

}  // namespace shoal
