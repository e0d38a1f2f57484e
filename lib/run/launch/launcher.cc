#include "lib/run/launch/launcher.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "lib/base/time/seconds.h"
#include "lib/base/time/time_units.h"
#include "lib/bus/bus/multicast_fault.h"
#include "lib/run/launch/launch_signals.h"
#include "lib/run/launch/recording.h"
#include "lib/run/run/log_plan.h"
#include "lib/run/run/run_app.h"
#include "lib/run/run/run_folder.h"
#include "lib/run/run/run_registry.h"

namespace shoal {

namespace {

constexpr int64_t kIdlePoll_us = 50'000;
constexpr char kOwnName[] = "shoal";

int64_t RandomMissionId() {
  int64_t id = 0;
  if (getrandom(&id, sizeof id, 0) != sizeof id) id = MonotonicMicroseconds();
  return std::max<int64_t>(id & std::numeric_limits<int64_t>::max(), 1);
}

ClockOptions MakeClockOptions(const RunOptions& options, const Mission& mission, int64_t mission_id,
                              const MissionSecret& secret) {
  return {.mission_id = mission_id,
          .secret = secret,
          .warp = options.warp,
          .fixed_pace = mission.netsim && !mission.netsim->allow_warp
                            ? "a mission with [netsim] keeps to the wall's clock"
                            : "",
          .tick_us = mission.tick_us,
          .start_utime = mission.start_utime,
          .last_step = mission.LastStep(),
          .timeout_us = static_cast<int64_t>(mission.participant_timeout_s * 1e6)};
}

/// Makes the folder for the participants' output: in the recording, or in the run folder.
Result<std::string> MakeLogFolder(const RunOptions& options, const Mission& mission,
                                  int port_base) {
  if (options.record_dir.empty()) return MakeRunSubfolder(fmt::format("{}-logs", port_base));
  const Result<bool> prepared = PrepareRecording(options, mission);
  if (!prepared.ok()) return Error{prepared.error()};
  std::string path = options.record_dir + "/logs";
  std::error_code error;
  // The folder was empty; what is there now has been made by another program.
  if (!std::filesystem::create_directory(path, error) && !error) {
    error = std::make_error_code(std::errc::file_exists);
  }
  if (error) return Error{fmt::format("cannot make the folder {}: {}", path, error.message())};
  return path;
}

std::vector<RosterProcess> ProcessesOf(const RunOptions& options, const Mission& mission) {
  return ShareOut(MakeRoster(mission, !options.record_dir.empty()), options.grouping);
}

std::vector<std::string> ParticipantNames(const std::vector<RosterProcess>& processes) {
  std::vector<std::string> names = {kOwnName};
  for (const RosterProcess& process : processes) {
    for (const RosterEntry& entry : process.entries) names.push_back(entry.name);
  }
  return names;
}

std::string LogNameOf(const RunOptions& options) {
  return options.compress.value_or(false) ? "mission.lcm.zst" : "mission.lcm";
}

/// Returns the options with what `--record` decides by the size that the log is expected to have;
/// states what it decided, and warns of what is not expected of a log.
RunOptions WithLogPlanned(const RunOptions& options, const Mission& mission) {
  if (options.record_dir.empty()) return options;
  RunOptions planned = options;
  const LogPlan plan = PlanLog(mission, options.log_channels, options.record_dir, options.compress);
  planned.compress = plan.is_compressed;
  for (const std::string& warning : plan.warnings) fmt::print(stderr, "shoal: {}\n", warning);
  if (plan.is_compressed && !options.compress) {
    fmt::print("The log may have {}: it is compressed, mission.lcm.zst (--plain: mission.lcm)\n",
               BytesText(plan.bytes));
  }
  return planned;
}

}  // namespace

Launcher::Launcher(const RunOptions& options, const Mission& mission, const LaunchedApps& apps,
                   PortPlan ports, int64_t mission_id, const MissionSecret& secret, int secret_fd,
                   std::string log_dir, std::optional<HostAccess> access)
    : options_(options),
      mission_(mission),
      ports_(std::move(ports)),
      context_{.options = options,
               .mission = mission,
               .ports = ports_,
               .mission_id = mission_id,
               .secret_fd = secret_fd,
               .log_dir = std::move(log_dir),
               .log_path =
                   options.record_dir.empty() ? "" : options.record_dir + "/" + LogNameOf(options)},
      processes_(ProcessesOf(options, mission)),
      wake_rule_(std::min(kWantedReceiveBuffer, ReceiveBufferLimit()),
                 access ? WakeRule::kFewOfRelay : WakeRule::kFew),
      group_({.mission_id = mission_id,
              .pid = getpid(),
              .secret = secret,
              .give_up_us = GiveUpAfter_us(mission)},
             ports_, transport_),
      director_(apps.make_director(mission, group_.Join(kOwnName))),
      clock_(MakeClockOptions(options, mission, mission_id, secret), ParticipantNames(processes_),
             ports_, transport_),
      hosts_(access ? std::make_unique<MissionHosts>(context_, secret, processes_, transport_,
                                                     std::move(*access))
                    : nullptr),
      supervision_(context_, processes_, clock_, terminal_, hosts_.get()) {
  group_.Attach(kOwnName, director_.get());
  group_.Listen();
  transport_.DeferFrom(ports_.shore_port());
  transport_.set_drop_filter(MakeLossFilter(options.lose, options.lose_forever));
  transport_.set_receiver(
      [this](int port, std::string_view channel, std::span<const uint8_t> datagram) {
        const int64_t now = MonotonicMicroseconds();
        wake_rule_.OnDatagram();
        // Before the clock gets the director's own answer, and with it goes on.
        if (director_->EndsMission()) clock_.MakeLast();
        if (port == ports_.done_port()) {
          clock_.OnDatagram(port, channel, datagram, now);
        } else {
          // First, so that hosts begin their step while the director takes its own.
          if (hosts_ != nullptr) hosts_->OnDatagram(port, channel, datagram, now);
          const int64_t step = group_.step();
          group_.OnDatagram(port, channel, datagram, now);
          if (group_.step() != step) wake_rule_.OnStep(MonotonicMicroseconds());
        }
      });
}

int Launcher::Run(int signal_fd) {
  if (!transport_.error().empty()) {
    supervision_.Fail(kExitEnvironment, transport_.error());
    return supervision_.exit_code();
  }
  if (hosts_ != nullptr) hosts_->WatchToo(signal_fd);
  if (supervision_.StartAll(signal_fd)) Loop(signal_fd);
  ended_us_ = MonotonicMicroseconds();
  supervision_.EndAll(signal_fd);
  const int code = Conclude();
  if (running_since_us_ != 0 && supervision_.ViewerStays()) {
    // For those that look for a running mission it has ended.
    Unregister(ports_.base());
    terminal_.Show("The mission has ended; the viewer shows it until Ctrl-C");
    supervision_.AwaitViewer(signal_fd);
  }
  return code;
}

void Launcher::LeaveVerdict(bool complete) {
  const std::string verdict =
      director_->VerdictText(Seconds(clock_.utime() - mission_.start_utime), complete);
  std::error_code error;
  const std::string log =
      context_.log_path.empty() ? "" : std::filesystem::absolute(context_.log_path, error).string();
  const Result<bool> kept =
      KeepEnded(ports_.base(), {.mission_id = context_.mission_id, .log = log, .verdict = verdict});
  if (!kept.ok()) terminal_.Warn("a viewer cannot show the verdict: " + kept.error());
  if (options_.record_dir.empty()) return;
  const Result<bool> written = WriteVerdict(options_.record_dir, verdict);
  if (!written.ok()) supervision_.Fail(kExitEnvironment, written.error());
}

void Launcher::Loop(int signal_fd) {
  while (clock_.state() != StepClock::State::kEnded) {
    int64_t now = MonotonicMicroseconds();
    group_.OnTime(now);
    clock_.OnTime(now);
    if (hosts_ != nullptr) hosts_->OnTime(now);
    if (clock_.state() == StepClock::State::kRunning && running_since_us_ == 0) {
      running_since_us_ = now;
    }
    supervision_.OnTime(now, group_.num_foreign());
    ShowProgress(now);
    int64_t deadline = std::min(group_.NextDeadline(), clock_.NextDeadline());
    if (hosts_ != nullptr) deadline = std::min(deadline, hosts_->NextDeadline());
    now = MonotonicMicroseconds();
    const int64_t wait = clock_.state() == StepClock::State::kGathering
                             ? kIdlePoll_us
                             : std::clamp<int64_t>(deadline - now, 0, kIdlePoll_us);
    const bool awaits_data = hosts_ != nullptr && hosts_->awaits_data();
    const bool sleeps = group_.awaits_tick() && !awaits_data && wake_rule_.SleepsThrough(now);
    const int extra_fd = hosts_ == nullptr ? signal_fd : hosts_->fd();
    if (transport_.Poll(sleeps ? wake_rule_.Timeout(wait, now) : wait, extra_fd,
                        sleeps ? WakeFor::kSteps : WakeFor::kAll)) {
      supervision_.OnSignals(signal_fd);
    }
  }
}

void Launcher::ShowProgress(int64_t wall_us) {
  if (options_.quiet || running_since_us_ == 0 || wall_us < next_progress_us_) return;
  next_progress_us_ = wall_us + (terminal_.is_interactive() ? kSecond_us / 4 : 5 * kSecond_us);
  const double mission_s = Seconds(clock_.utime() - mission_.start_utime);
  const double wall_s = std::max(Seconds(wall_us - running_since_us_), 1e-3);
  terminal_.ShowProgress(fmt::format(
      "{:8.1f} of {:.1f} s  {:6.1f} x real time{}  {} vehicles  {} reports delivered, {} blocked",
      mission_s, mission_.duration_s, mission_s / wall_s, clock_.paused() ? ", paused" : "",
      mission_.vehicles.size(), director_->num_delivered(), director_->num_blocked()));
}

int Launcher::Conclude() {
  const bool complete = supervision_.exit_code() == 0;
  const RunCounters& counters = clock_.counters();
  const bool reproducible =
      complete && counters.outside == 0 && !clock_.membership_changed() && !mission_.netsim;
  terminal_.EndProgress();
  std::string summary;
  if (running_since_us_ != 0) {
    const double mission_s = Seconds(clock_.utime() - mission_.start_utime);
    const double wall_s = std::max(Seconds(ended_us_ - running_since_us_), 1e-3);
    const size_t num_participants = ParticipantNames(processes_).size();
    const size_t num_processes = processes_.size() + 1;
    const std::string in_processes =
        num_processes == num_participants ? "" : fmt::format(" in {} processes", num_processes);
    summary = fmt::format(
        "{:.1f} s of mission in {:.2f} s ({:.1f} x real time), {} participants{}, {} layout\n"
        "Bus: {} messages, {} asked for again, {} ticks again, {} undecodable, {} of other "
        "missions, {} from outside, {} refused\n"
        "Reproducible: {}\n\n{}",
        mission_s, wall_s, mission_s / wall_s, num_participants, in_processes,
        Name(ports_.layout()), counters.messages, counters.repeated, counters.ticks_again,
        counters.undecodable, counters.foreign, counters.outside, counters.refused,
        reproducible           ? "yes"
        : counters.outside > 0 ? "no: messages came from outside the step protocol"
        : mission_.netsim      ? "no: clients of netsim_manager come from outside"
        : !complete            ? "no: the mission did not run to its end"
                               : "no: not all participants took part from beginning to end",
        (hosts_ == nullptr ? "" : hosts_->Summary()) + director_->Summary(complete));
  }
  if (running_since_us_ != 0) LeaveVerdict(complete);
  if (!options_.record_dir.empty()) {
    const Result<bool> written = WriteSummary(options_.record_dir, summary);
    if (!written.ok()) supervision_.Fail(kExitEnvironment, written.error());
    terminal_.Print(fmt::format("Recorded in {}: {}{}, mission.toml, run.txt, {}logs/\n",
                                options_.record_dir, LogNameOf(options_),
                                supervision_.HasLost("recorder") ? " (cut short)" : "",
                                written.ok() ? "summary.txt, verdict.txt, " : ""));
    if (options_.view)
      terminal_.Print(fmt::format("To look at it: shoal view {}\n", options_.record_dir));
  }
  terminal_.Print(summary);
  if (running_since_us_ != 0) supervision_.ShowCause();
  if (supervision_.exit_code() != 0) return supervision_.exit_code();
  return director_->Passed() ? 0 : static_cast<int>(kExitMissionFailed);
}

int RunMission(const RunOptions& asked, const Mission& mission, const LaunchedApps& apps) {
  const auto fail = [](const std::string& why) {
    fmt::print(stderr, "shoal: {}\n", why);
    return static_cast<int>(kExitEnvironment);
  };
  if (const std::string fault = MulticastFault(); !fault.empty()) return fail(fault);
  if (mission.netsim && !mission.netsim->allow_warp && asked.warp != 1) {
    fmt::print(stderr,
               "shoal: a mission with [netsim] runs at --warp 1: modem drivers compare their clock "
               "with the wall's. Where yours do not, write allow_warp = true in [netsim]\n");
    return kExitUsage;
  }
  const RunOptions options = WithLogPlanned(asked, mission);
  // Before anything is made or started, so that nothing has to be undone.
  const std::vector<std::string> missing = MissingPrograms(mission, ProcessesOf(options, mission));
  if (!missing.empty()) return fail(fmt::format("{}", fmt::join(missing, "\nshoal: ")));
  std::optional<HostAccess> access;
  if (!HostsInUse(mission).empty()) {
    Result<HostAccess> prepared = PrepareHosts(mission, options, apps);
    if (!prepared.ok()) {
      fmt::print(stderr, "shoal: {}\n", prepared.error());
      return kExitUsage;
    }
    access = std::move(*prepared);
  }
  const std::vector<std::string> vehicles = VehicleNames(mission);
  const Layout layout =
      options.layout.value_or(PortPlan::Suggest(static_cast<int>(vehicles.size())));
  const Result<int> base =
      ClaimPorts(options.port_base, PortPlan::NumPorts(layout, static_cast<int>(vehicles.size())));
  if (!base.ok()) return fail(base.error());

  RunningMission running{
      .name = mission.name,
      .file = std::filesystem::absolute(mission.file).lexically_normal().string(),
      .folder = WorkingFolder(),
      .mission_id = RandomMissionId(),
      .port_base = *base,
      .layout = layout,
      .grouping = Name(options.grouping),
      .pid = getpid(),
      .vehicles = vehicles,
      .overrides = options.overrides,
      .groups = GroupsOf(mission),
      .orders = OrdersOf(mission)};
  for (const Vehicle& vehicle : mission.vehicles) {
    if (vehicle.helm == Provider::kNone) running.without_helm.push_back(vehicle.name);
  }
  const MissionSecret secret = RandomSecret();
  if (const auto kept = KeepSecret(*base, secret); !kept.ok()) return fail(kept.error());
  const Result<int> secret_fd = SecretInMemory(secret);
  if (!secret_fd.ok()) return fail(secret_fd.error());
  // Before the recording, which would leave a folder behind.
  if (const auto registered = Register(running); !registered.ok()) return fail(registered.error());
  const Result<std::string> log_dir = MakeLogFolder(options, mission, *base);
  if (!log_dir.ok()) {
    Unregister(*base);
    return fail(log_dir.error());
  }
  LaunchTerminal::Print(fmt::format(
      "{}: {} vehicles, seed {}, LCM ports {} to {} ({})\n", mission.name, vehicles.size(),
      mission.seed, *base,
      *base + PortPlan::NumPorts(layout, static_cast<int>(vehicles.size())) - 1, Name(layout)));
  int code = 0;
  {
    const int signal_fd = BlockSignals();
    Launcher launcher(options, mission, apps, running.Ports(), running.mission_id, secret,
                      *secret_fd, *log_dir, std::move(access));
    code = launcher.Run(signal_fd);
    close(signal_fd);
  }
  close(*secret_fd);
  Unregister(*base);
  return code;
}

}  // namespace shoal
