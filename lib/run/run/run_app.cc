#include "lib/run/run/run_app.h"

#include <fmt/format.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>

#include "lib/base/check/result.h"
#include "lib/bus/bus/lcm_transport.h"
#include "lib/bus/bus/multicast_fault.h"
#include "lib/bus/os/wait_set.h"
#include "lib/mission/file/load.h"
#include "lib/run/run/live.h"
#include "lib/run/run/roster.h"
#include "lib/run/run/run_registry.h"
#include "lib/run/run/step_group.h"
#include "lib/run/run/wake_rule.h"

namespace shoal {

namespace {

std::atomic<bool> stop_wanted = false;

void OnSignal(int) { stop_wanted = true; }

constexpr int64_t kPollInterval_us = 100'000;
/// After the end an app stays until nothing has come for this long: others may have missed what it
/// published last, and ask every 50 ms. (The launcher ends its own children as soon as all have
/// answered.)
constexpr int64_t kLinger_us = 300'000;

/// Waits until a launcher runs this mission file, for apps that a user starts; nothing where a
/// signal asks for the end.
Result<std::optional<RunningMission>> AwaitMission(const std::string& file) {
  std::error_code error;
  const std::string wanted = std::filesystem::absolute(file, error).lexically_normal().string();
  bool is_announced = false;
  while (!stop_wanted) {
    const Result<std::vector<RunningMission>> missions = RunningMissions();
    if (!missions.ok()) return Error{missions.error()};
    for (const RunningMission& mission : *missions) {
      if (mission.file == wanted) return std::optional(mission);
    }
    if (!is_announced) {
      fmt::print(stderr, "waiting for `shoal run {}` (Ctrl-C ends)\n", file);
      is_announced = true;
    }
    usleep(kPollInterval_us);  // A signal ends it; a mission's entry is a file that may appear.
  }
  return std::optional<RunningMission>();
}

/// Returns the status pages of all participants of the process.
std::string Pages(const StepGroup& group, const std::vector<Joining>& joining) {
  std::string text;
  for (const Joining& each : joining) {
    text += Format(group.Status(each.name), each.name, group.step()) + "\n";
  }
  return text;
}

/// Shows the status pages on a terminal, again once a second.
void ShowOnTerminal(const StepGroup& group, const std::vector<Joining>& joining) {
  fmt::print("\033[2J\033[H{}", Pages(group, joining));
  std::fflush(stdout);
}

void CatchSignals() {
  struct sigaction action {};
  action.sa_handler = OnSignal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

/// Returns the ports from `port_base` on, or prints why there is no room for them.
std::optional<PortPlan> PlanPorts(const std::string& name, const Mission& mission, int port_base,
                                  std::optional<Layout> layout) {
  const std::vector<std::string> vehicles = VehicleNames(mission);
  const auto num_vehicles = static_cast<int>(vehicles.size());
  if (port_base + PortPlan::NumPorts(Layout::kCommunities, num_vehicles) > 65536) {
    fmt::print(stderr, "{}: --port {} leaves no room for the mission's ports below 65536\n", name,
               port_base);
    return std::nullopt;
  }
  return PortPlan(port_base, layout.value_or(PortPlan::Suggest(num_vehicles)), vehicles);
}

}  // namespace

int64_t MonotonicMicroseconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return int64_t{now.tv_sec} * 1'000'000 + now.tv_nsec / 1000;
}

int64_t UnixMicroseconds() {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  return int64_t{now.tv_sec} * 1'000'000 + now.tv_nsec / 1000;
}

int64_t ProcessorMicroseconds() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return int64_t{used.tv_sec} * 1'000'000 + used.tv_nsec / 1000;
}

int64_t GiveUpAfter_us(const Mission& mission) {
  const auto timeout_us = static_cast<int64_t>(mission.participant_timeout_s * 1e6);
  return std::min(StepGroupOptions{}.give_up_us, timeout_us / 2);
}

std::function<bool(std::string_view)> MakeLossFilter(double lose, const std::string& lose_forever) {
  if (lose <= 0 && lose_forever.empty()) return {};
  return
      [lose, lose_forever, state = uint64_t{0x9e3779b97f4a7c15}](std::string_view channel) mutable {
        if (channel == lose_forever) return true;
        // xorshift64: the choice of lost datagrams must not be tied to the mission's own streams.
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        return static_cast<double>(state >> 11) * 0x1p-53 < lose;
      };
}

int RunJoined(const AppOptions& options, const std::string& title, const Mission& mission,
              const std::vector<Joining>& joining) {
  CatchSignals();
  int port_base = options.port_base;
  int64_t mission_id = options.mission_id;
  std::optional<Layout> layout = options.layout;
  if (port_base == 0) {
    const Result<std::optional<RunningMission>> awaited = AwaitMission(options.mission_file);
    if (!awaited.ok()) {
      fmt::print(stderr, "{}: {}\n", title, awaited.error());
      return kExitEnvironment;
    }
    const std::optional<RunningMission>& running = *awaited;
    if (!running) return kExitOk;
    port_base = running->port_base;
    if (mission_id == 0) mission_id = running->mission_id;
    if (!layout) layout = running->layout;
  } else if (!layout) {
    if (const auto running = FindRunningMission(port_base); running.ok()) layout = running->layout;
  }
  const std::optional<PortPlan> plan = PlanPorts(title, mission, port_base, layout);
  if (!plan) return kExitUsage;

  if (const std::string fault = MulticastFault(); !fault.empty()) {
    fmt::print(stderr, "{}: {}\n", title, fault);
    return kExitEnvironment;
  }
  const Result<MissionSecret> secret = FindSecret(port_base);
  if (!secret.ok()) {
    fmt::print(stderr, "{}: {}\n", title, secret.error());
    return kExitEnvironment;
  }
  LcmTransport transport;
  transport.set_drop_filter(MakeLossFilter(options.lose, options.lose_forever));
  StepGroup group({.mission_id = mission_id,
                   .pid = static_cast<int32_t>(getpid()),
                   .secret = *secret,
                   .give_up_us = GiveUpAfter_us(mission)},
                  *plan, transport);
  transport.DeferFrom(plan->shore_port());
  WakeRule wake_rule(std::min(kWantedReceiveBuffer, ReceiveBufferLimit()));
  int64_t last_received_us = 0;
  transport.set_receiver(
      [&](int port, std::string_view channel, std::span<const uint8_t> datagram) {
        last_received_us = MonotonicMicroseconds();
        const int64_t step = group.step();
        wake_rule.OnDatagram();
        group.OnDatagram(port, channel, datagram, last_received_us);
        if (group.step() != step) wake_rule.OnStep(MonotonicMicroseconds());
      });
  std::vector<std::unique_ptr<App>> apps;
  for (const Joining& each : joining) {
    apps.push_back(each.make(group.Join(each.name)));
    group.Attach(each.name, apps.back().get());
  }
  group.Listen();
  if (!transport.error().empty()) {
    fmt::print(stderr, "{}: {}\n", title, transport.error());
    return kExitEnvironment;
  }
  WaitSet served;
  bool serves = false;
  for (const auto& app : apps)
    serves = (app->ServedFd() >= 0 && served.Add(app->ServedFd())) || serves;

  const bool on_terminal = isatty(STDOUT_FILENO) == 1;
  int64_t next_show = 0;
  while (!group.ended() && !stop_wanted) {
    const int64_t now = MonotonicMicroseconds();
    group.OnTime(now);
    if (on_terminal && now >= next_show) {
      ShowOnTerminal(group, joining);
      next_show = now + kTerminalInterval_us;
    }
    for (const auto& app : apps) {
      if (app->ServedFd() >= 0) app->Serve(now, UnixMicroseconds());
    }
    const bool sleeps = group.awaits_tick() && wake_rule.SleepsThrough(now);
    const int64_t wait = std::min(group.NextDeadline() - now, kPollInterval_us);
    transport.Poll(sleeps ? wake_rule.Timeout(wait, now) : wait, serves ? served.fd() : -1,
                   sleeps ? WakeFor::kSteps : WakeFor::kAll);
  }
  if (!group.ended()) {
    for (const auto& app : apps) app->End();
  }
  fmt::print("{}{}: {}\n", Pages(group, joining), title,
             group.ended() ? "the mission has ended" : "ended by a signal");
  std::fflush(stdout);
  while (!stop_wanted && MonotonicMicroseconds() - last_received_us < kLinger_us) {
    transport.Poll(kPollInterval_us / 2);
  }
  return kExitOk;
}

std::optional<Mission> LoadToTakePart(const AppOptions& options) {
  LoadedMission loaded = LoadMission(options.mission_file, options.overrides);
  for (const std::string& error : loaded.errors) fmt::print(stderr, "{}\n", error);
  if (!loaded.errors.empty()) return std::nullopt;
  if (loaded.mission.draws_seed) {
    fmt::print(stderr,
               "{}: seed = \"random\" is drawn once for all processes: give the number that `shoal "
               "run` shows, --set mission.seed=N\n",
               options.mission_file);
    return std::nullopt;
  }
  return std::move(loaded.mission);
}

int RunVehicleApp(const AppInfo& info, int argc, char** argv, const VehicleAppFactory& make) {
  const AppOptions options = ParseAppOptionsOrExit(info, argc, argv);
  const std::optional<Mission> mission = LoadToTakePart(options);
  if (!mission) return kExitUsage;
  const Vehicle* vehicle = mission->FindVehicle(options.vehicle);
  if (vehicle == nullptr) {
    fmt::print(stderr, "{}: no vehicle '{}' in {}; it has: {}\n", info.name, options.vehicle,
               options.mission_file, fmt::join(VehicleNames(*mission), ", "));
    return kExitUsage;
  }
  const std::string misfit = info.misfit == nullptr ? "" : info.misfit(*mission, *vehicle);
  if (!misfit.empty()) {
    fmt::print(stderr, "{}: {}\n", info.name, misfit);
    return kExitUsage;
  }
  const std::string name =
      options.alias.empty() ? ParticipantName(info.name, vehicle->name) : options.alias;
  return RunJoined(
      options, name, *mission,
      {{.name = name, .make = [&](Bus& bus) { return make(*mission, *vehicle, bus, options); }}});
}

int RunMissionApp(const AppInfo& info, int argc, char** argv, const MissionAppFactory& make) {
  const AppOptions options = ParseAppOptionsOrExit(info, argc, argv);
  const std::optional<Mission> mission = LoadToTakePart(options);
  if (!mission) return kExitUsage;
  const std::string name = options.alias.empty() ? info.name : options.alias;
  if (!options.live) {
    return RunJoined(
        options, name, *mission,
        {{.name = name, .make = [&](Bus& bus) { return make(*mission, bus, options); }}});
  }
  CatchSignals();
  const int port_base = options.port_base == 0 ? PortPlan::kDefaultBase : options.port_base;
  const std::optional<PortPlan> plan = PlanPorts(name, *mission, port_base, options.layout);
  if (!plan) return kExitUsage;
  return RunLive({.name = name,
                  .ports = *plan,
                  .tick_us = mission->tick_us,
                  .stopped = [] { return stop_wanted.load(); }},
                 *mission, [&](const Mission& live, Bus& bus) { return make(live, bus, options); });
}

}  // namespace shoal
