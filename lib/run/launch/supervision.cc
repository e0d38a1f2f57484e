#include "lib/run/launch/supervision.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <span>

#include "lib/base/time/time_units.h"
#include "lib/bus/bus/multicast_fault.h"
#include "lib/run/run/run_app.h"
#include "lib/run/run/run_registry.h"

namespace shoal {

namespace {

constexpr int64_t kPatience_us = 700'000;        ///< For the step under way when the end is wanted.
constexpr int64_t kExitPatience_us = 1'000'000;  ///< For processes to leave after END.
constexpr double kLeastTimeout_s = 5;  ///< A short one is for steps; programs load no faster.
constexpr double kTimeoutsToStart = 4;
constexpr double kStartOfOne_s = 0.5;  ///< Processes that start share the machine's cores.
constexpr size_t kMaxNames = 5;        ///< In one line.
constexpr int64_t kWaitingLine_us = 10 * kSecond_us;  ///< While a user has to start a program.
constexpr int kMaxRestarts = 5;                       ///< Of one participant; more is a crash loop.

constexpr char kViewer[] = "shoal-viewer";

/// Explains a message that was lost for good.
std::string LossAdvice() {
  constexpr int kUsefulReceiveBuffer = 4'194'304;
  std::string advice = "\nThe bus loses messages for good: --warp is more than this machine can, ";
  advice += ReceiveBufferLimit() < kUsefulReceiveBuffer
                ? fmt::format(
                      "or the receive buffer is too small (now {} bytes):\n    sudo sysctl "
                      "-w net.core.rmem_max={}\n",
                      ReceiveBufferLimit(), kUsefulReceiveBuffer)
                : std::string("or a program floods its ports. ");
  return advice + "`shoal doctor` looks for more.";
}

/// Returns "a, b and 3 others".
std::string Names(const std::vector<std::string>& names) {
  const size_t shown = std::min(names.size(), kMaxNames);
  std::string text = fmt::format("{}", fmt::join(std::span(names).first(shown), ", "));
  if (names.size() > shown) text += fmt::format(" and {} others", names.size() - shown);
  return text;
}

/// True where a user starts the process.
bool IsByHand(const RosterProcess& process) {
  return process.entries.front().provider == Provider::kHand;
}

/// True where it runs on another computer.
bool IsOnHost(const RosterProcess& process) { return !process.entries.front().host.empty(); }

/// Returns ", and with it helm_alpha, ...": the participants of a group; empty: it is not one.
std::string AndItsParticipants(const RosterProcess& process) {
  if (!process.is_group()) return "";
  std::vector<std::string> names;
  for (const RosterEntry& entry : process.entries) names.push_back(entry.name);
  return ", and with it " + Names(names);
}

/// Waits for the exit of a child, which `signal_fd` reports, or for `timeout_us`. Other signals are
/// read from it and ignored, since the mission is ending.
void AwaitExit(int signal_fd, int64_t timeout_us) {
  pollfd waited = {.fd = signal_fd, .events = POLLIN, .revents = 0};
  poll(&waited, 1, static_cast<int>((timeout_us + 999) / 1000));
  signalfd_siginfo info{};
  while (read(signal_fd, &info, sizeof info) == sizeof info) {
  }
}

}  // namespace

int64_t StartLimit_us(double participant_timeout_s, size_t num_processes) {
  const double limit_s = kTimeoutsToStart * std::max(participant_timeout_s, kLeastTimeout_s) +
                         kStartOfOne_s * static_cast<double>(num_processes);
  return static_cast<int64_t>(limit_s * 1e6);
}

Supervision::Supervision(const LaunchContext& context, const std::vector<RosterProcess>& processes,
                         StepClock& clock, LaunchTerminal& terminal, MissionHosts* hosts)
    : context_(context), processes_(processes), clock_(clock), terminal_(terminal), hosts_(hosts) {}

const RosterProcess* Supervision::ProcessOf(const std::string& participant) const {
  for (const RosterProcess& process : processes_) {
    for (const RosterEntry& entry : process.entries) {
      if (entry.name == participant) return &process;
    }
  }
  return nullptr;
}

const RosterProcess* Supervision::FindProcess(const std::string& name) const {
  const auto found = std::find_if(processes_.begin(), processes_.end(),
                                  [&](const RosterProcess& each) { return each.name == name; });
  return found == processes_.end() ? nullptr : &*found;
}

bool Supervision::StartAll(int signal_fd) {
  started_us_ = MonotonicMicroseconds();
  // First, so that it receives each message of the others' start only once.
  if (context_.options.view && !StartViewer()) return false;
  if (context_.options.view && context_.options.warp == 0) {
    AwaitPage(signal_fd);
    if (exit_code_ != 0) return false;
    started_us_ = MonotonicMicroseconds();
  }
  for (const RosterProcess& process : processes_) {
    // A host starts its participants with the mission that it is offered.
    if (IsByHand(process) || IsOnHost(process)) continue;
    if (!StartProcess(process)) return false;
  }
  return !context_.options.lcm_logger || StartLoggers();
}

bool Supervision::StartProcess(const RosterProcess& process) {
  if (!IsOnHost(process)) return Start(CommandOf(process, context_));
  hosts_->Start(process);
  return true;
}

bool Supervision::Start(const Result<ChildCommand>& command) {
  if (!command.ok()) {
    Fail(kExitEnvironment, command.error());
    return false;
  }
  const Result<pid_t> pid = children_.Start(*command);
  if (!pid.ok()) Fail(kExitEnvironment, pid.error());
  return pid.ok();
}

bool Supervision::StartViewer() {
  const Result<ChildCommand> command = ViewerCommand(context_);
  if (!Start(command)) return false;
  viewer_log_ = command->log_path;
  viewer_address_.Await(command->log_path, started_us_);
  return true;
}

void Supervision::AwaitPage(int signal_fd) {
  constexpr int64_t kLook_us = 100'000;
  terminal_.Show(fmt::format("with --warp max the mission begins when its page is open, or in {} s",
                             kPagePatience_us / kSecond_us));
  for (;;) {
    OnSignals(signal_fd);
    const int64_t now_us = MonotonicMicroseconds();
    viewer_address_.OnTime(now_us, &terminal_);
    if (exit_code_ != 0 || !children_.IsRunning(kViewer)) return;
    if (ViewerAddress::HasPage(viewer_log_)) return;
    if (now_us - started_us_ > kPagePatience_us) {
      terminal_.Warn("no page was opened: the mission begins without");
      return;
    }
    pollfd waited = {.fd = signal_fd, .events = POLLIN, .revents = 0};
    poll(&waited, 1, static_cast<int>(kLook_us / 1000));
  }
}

bool Supervision::ViewerStays() const {
  return context_.options.view && !is_interrupted_ && children_.IsRunning(kViewer);
}

void Supervision::AwaitViewer(int signal_fd) {
  is_killing_ = false;
  std::optional<int64_t> asked_us;
  while (children_.IsRunning(kViewer)) {
    signalfd_siginfo info{};
    while (read(signal_fd, &info, sizeof info) == sizeof info) {
      if (info.ssi_signo == SIGCHLD) continue;
      children_.Signal(kViewer, asked_us ? SIGKILL : SIGTERM);
      if (!asked_us) asked_us = MonotonicMicroseconds();
    }
    OnChildExits();
    if (asked_us && MonotonicMicroseconds() - *asked_us > kExitPatience_us) {
      children_.Signal(kViewer, SIGKILL);
    }
    if (!children_.IsRunning(kViewer)) return;
    pollfd waited = {.fd = signal_fd, .events = POLLIN, .revents = 0};
    poll(&waited, 1, asked_us ? static_cast<int>(kExitPatience_us / 1000) : -1);
  }
}

bool Supervision::StartLoggers() {
  Result<std::vector<ChildCommand>> loggers = LcmLoggerCommands(context_);
  if (!loggers.ok()) {
    Fail(kExitEnvironment, loggers.error());
    return false;
  }
  for (const ChildCommand& command : *loggers) {
    if (!Start(command)) return false;
    loggers_.push_back(command.name);
  }
  return true;
}

void Supervision::Fail(int exit_code, const std::string& why) {
  terminal_.Warn(why);
  if (exit_code_ != kExitEnvironment) cause_ = why;
  exit_code_ = exit_code;
}

void Supervision::ShowCause() {
  if (!lost_later_.empty()) {
    terminal_.Warn(fmt::format("after that, {} processes were lost too ({}); their output: {}/",
                               lost_later_.size(), Names({lost_later_.begin(), lost_later_.end()}),
                               context_.log_dir));
  }
  if (exit_code_ == kExitEnvironment) terminal_.Warn("Cause: " + cause_);
}

bool Supervision::FailedByNetwork() {
  const std::string fault = MulticastFault();
  if (!fault.empty()) Fail(kExitEnvironment, fault);
  return !fault.empty();
}

void Supervision::OnTime(int64_t wall_us, int64_t num_foreign) {
  CheckHosts();
  CheckGathering(wall_us);
  CheckSilence(wall_us);
  CheckFaults(wall_us, num_foreign);
  viewer_address_.OnTime(wall_us, &terminal_);
}

void Supervision::OnSignals(int signal_fd) {
  signalfd_siginfo info{};
  bool is_any = false;
  while (read(signal_fd, &info, sizeof info) == sizeof info) {
    is_any = true;
    if (info.ssi_signo == SIGCHLD) continue;  // Several may share one; Reap finds all.
    if (is_interrupted_) {
      is_killing_ = true;  // Asked twice: wait no longer.
      children_.SignalAll(SIGKILL);
    } else {
      is_interrupted_ = true;
      Fail(kExitMissionFailed, "interrupted: ending the mission");
    }
  }
  if (is_any) OnChildExits();
}

void Supervision::OnChildExits() {
  for (const ChildExit& exit : children_.Reap()) OnChildExit(exit);
}

void Supervision::OnChildExit(const ChildExit& exit) {
  const RosterProcess* process = FindProcess(exit.name);
  const bool is_over = clock_.state() == StepClock::State::kEnded;
  const auto drop_exited = [&] {
    if (process == nullptr) return;
    for (const RosterEntry& entry : process->entries) {
      clock_.DropExited(entry.name, MonotonicMicroseconds());
    }
  };
  if (exit.name == kViewer) {
    viewer_address_.Forget();
    if (is_over || is_killing_) return;
    terminal_.Warn(fmt::format("{} {}; the mission goes on", exit.name, exit.how));
    for (const std::string& line : exit.last_lines) terminal_.Warn("    " + line);
  } else if (is_killing_ || ((process == nullptr || is_over || is_ending_) && exit.clean)) {
    drop_exited();
  } else if (process == nullptr) {
    terminal_.Warn(fmt::format("{} {}; the recorder goes on", exit.name, exit.how));
  } else if (is_over) {
    terminal_.Warn(fmt::format("{} {} after the end", exit.name, exit.how));
  } else if (clock_.state() == StepClock::State::kEnding && exit.clean) {
    for (const RosterEntry& entry : process->entries) {
      clock_.Leave(entry.name, MonotonicMicroseconds());
    }
  } else {
    drop_exited();
    OnLost(*process, fmt::format("{} (pid {}) {}", exit.name, exit.pid, exit.how), exit.last_lines);
  }
}

/// Hosts that were lost, and how their processes ended.
void Supervision::CheckHosts() {
  if (hosts_ == nullptr) return;
  for (const std::string& note : hosts_->TakeNotes()) terminal_.Warn(note);
  for (const HostExit& exit : hosts_->TakeExits()) {
    OnChildExit({.name = exit.name,
                 .pid = static_cast<pid_t>(exit.pid),
                 .clean = exit.clean,
                 .how = exit.how,
                 .last_lines = exit.last_lines});
  }
  for (const HostTrouble& trouble : hosts_->TakeTroubles()) OnHostTrouble(trouble);
}

void Supervision::OnHostTrouble(const HostTrouble& trouble) {
  if (clock_.state() == StepClock::State::kEnded) return;
  std::vector<std::string> participants;
  for (const RosterProcess& process : processes_) {
    for (const RosterEntry& entry : process.entries) {
      if (entry.host == trouble.host) participants.push_back(entry.name);
    }
  }
  const auto host =
      std::find_if(context_.mission.hosts.begin(), context_.mission.hosts.end(),
                   [&](const HostOptions& each) { return each.name == trouble.host; });
  const bool is_running = clock_.state() == StepClock::State::kRunning;
  const bool ends = trouble.is_fatal || host->on_loss == OnLoss::kEnd || !is_running;
  const bool is_cause = exit_code_ == 0;
  if (trouble.is_fatal) {
    if (is_cause) Fail(kExitEnvironment, trouble.how);
  } else {
    if (is_cause) terminal_.Warn("LOST: " + trouble.how);
    if (is_cause && ends) {
      Fail(kExitEnvironment, fmt::format("the mission ends without {}", trouble.host));
      cause_ = trouble.how;
    } else if (is_cause) {
      terminal_.Warn(fmt::format("the mission goes on without {} ({}){}", trouble.host,
                                 Names(participants),
                                 host->on_loss == OnLoss::kRestart ? ", until it is back" : ""));
    }
  }
  for (const std::string& name : participants) clock_.Drop(name, MonotonicMicroseconds());
}

void Supervision::CheckSilence(int64_t wall_us) {
  std::map<std::string, RosterProcess> silent;  // By name.
  for (const std::string& participant : clock_.Silent(wall_us)) {
    const RosterProcess* process = ProcessOf(participant);
    if (process == nullptr) {  // The launcher's own, which cannot be started again.
      silent[participant] = {
          .name = participant,
          .entries = {RosterEntry{.name = participant, .provider = Provider::kHand}}};
    } else {
      silent[process->name] = *process;
    }
  }
  for (const auto& [name, process] : silent) {
    if (IsOnHost(process)) hosts_->Signal(process, SIGKILL);
    children_.Signal(name, SIGKILL);
    OnLost(process,
           fmt::format("{} has not answered step {} for {} s of wall time (stopped, or hung)", name,
                       clock_.step(), context_.mission.participant_timeout_s),
           {});
  }
}

void Supervision::Drop(const RosterProcess& process) {
  for (const RosterEntry& entry : process.entries) {
    clock_.Drop(entry.name, MonotonicMicroseconds());
  }
}

void Supervision::OnLost(const RosterProcess& process, const std::string& how,
                         const std::vector<std::string>& last_lines) {
  const std::string& name = process.name;
  if (exit_code_ != 0) {
    // A consequence of what ends the mission, most often; its line would bury the cause.
    if (!lost_.contains(name)) lost_later_.insert(name);
    Drop(process);
    return;
  }
  if (FailedByNetwork()) {
    OnLost(process, how, last_lines);
    return;
  }
  const bool is_new = lost_.insert(name).second;
  if (is_new) {
    terminal_.Warn("LOST: " + how + AndItsParticipants(process));
    for (const std::string& line : last_lines) terminal_.Warn("    " + line);
  }
  const bool is_running = clock_.state() == StepClock::State::kRunning;
  Drop(process);
  // A second recorder would empty the log of the first, and none would leave it cut.
  if (context_.mission.on_loss == OnLoss::kEnd || !is_running || name == "recorder") {
    Fail(kExitEnvironment, fmt::format("the mission ends without {}", name));
    cause_ = how;
  } else if (context_.mission.on_loss == OnLoss::kRestart && !IsByHand(process)) {
    Restart(process);
  } else if (is_new) {
    terminal_.Warn(fmt::format("the mission goes on without {}", name));
  }
}

void Supervision::Restart(const RosterProcess& process) {
  const std::string& name = process.name;
  const bool is_running =
      children_.IsRunning(name) || (hosts_ != nullptr && hosts_->IsRunning(name));
  if (is_running) return;  // It has been killed; its exit comes next.
  if (++num_restarts_[name] > kMaxRestarts) {
    Fail(kExitEnvironment, fmt::format("{} was restarted {} times already", name, kMaxRestarts));
  } else if (StartProcess(process)) {
    lost_.erase(name);
    terminal_.Warn(fmt::format("{} starts again", name));
  }
}

void Supervision::CheckGathering(int64_t wall_us) {
  if (clock_.state() != StepClock::State::kGathering) return;
  if (exit_code_ != 0) return;
  const std::vector<std::string> awaited = clock_.Awaited();
  std::vector<std::string> late;
  const int64_t limit_us = StartLimit_us(context_.mission.participant_timeout_s, processes_.size());
  if (awaited.empty() && clock_.paused() && !has_shown_paused_) {
    has_shown_paused_ = true;
    terminal_.Warn(
        "all participants are there, and the clock is paused: `shoal send clock resume`");
  }
  const bool shows = wall_us >= next_waiting_line_us_;
  if (shows) next_waiting_line_us_ = wall_us + kWaitingLine_us;
  for (const RosterProcess& process : processes_) {
    const RosterEntry& first = process.entries.front();  // All of a group report at once.
    if (std::find(awaited.begin(), awaited.end(), first.name) == awaited.end()) continue;
    if (IsByHand(process)) {
      if (!shows) continue;
      terminal_.Warn(
          IsOnHost(process)
              ? fmt::format("waiting for {} on host {}, whose terminal shows the command",
                            first.name, first.host)
              : fmt::format("waiting for {}: {}", first.name, HandCommand(first, context_)));
    } else if (wall_us - started_us_ > limit_us) {
      late.push_back(process.name);
    }
  }
  if (late.empty() || FailedByNetwork()) return;
  Fail(kExitEnvironment,
       fmt::format(
           "{} of {} processes did not report within {} s of their start: {}. Their output: "
           "{}/NAME.txt. On a slow or busy machine, raise participant_timeout_s in "
           "[mission]",
           late.size(), processes_.size(), limit_us / kSecond_us, Names(late), context_.log_dir));
}

void Supervision::CheckFaults(int64_t wall_us, int64_t num_foreign) {
  if (!clock_.fault().empty() && exit_code_ == 0 && !FailedByNetwork()) {
    std::string why = clock_.fault();
    if (why.find("never reached") != std::string::npos) why += LossAdvice();
    Fail(kExitEnvironment, why);
  }
  if (!has_shown_unregistered_ && !clock_.unregistered().empty()) {
    has_shown_unregistered_ = true;
    const std::vector<std::string> awaited = clock_.Awaited();
    terminal_.Warn(
        fmt::format("{} is an unregistered participant: the mission has none of this name; {}",
                    clock_.unregistered(),
                    awaited.empty() ? "it waits for no other"
                                    : fmt::format("it waits for {}", fmt::join(awaited, ", "))));
  }
  if (!has_shown_refused_ && !clock_.refused().empty()) {
    has_shown_refused_ = true;
    terminal_.Warn(fmt::format(
        "an answer in the name of {} was refused: its seal does not prove this mission's "
        "secret, which is in {} (docs/extending/step_protocol.md)",
        clock_.refused(), SecretPath(context_.ports.base())));
  }
  if (!has_shown_foreign_ && clock_.counters().foreign + num_foreign > 0) {
    has_shown_foreign_ = true;
    terminal_.Warn(
        fmt::format("messages of another mission arrive on ports {} to {} and are rejected: choose "
                    "other ports with --port",
                    context_.ports.base(), context_.ports.base() + context_.ports.num_ports() - 1));
  }
  if (exit_code_ != 0) clock_.Stop(wall_us, kPatience_us);
}

void Supervision::EndAll(int signal_fd) {
  is_ending_ = true;
  if (hosts_ != nullptr) hosts_->End();
  // lcm-logger ends on SIGINT. Shoal's own have answered END, or receive a signal now; a user's get
  // the time to leave by themselves.
  const std::string kept = ViewerStays() ? kViewer : "";
  const auto num_to_end = [&] {
    return children_.num_running() - (children_.IsRunning(kept) ? 1 : 0);
  };
  if (kept.empty()) children_.Signal(kViewer, SIGTERM);
  for (const std::string& name : loggers_) children_.Signal(name, SIGINT);
  for (const RosterProcess& process : processes_) {
    if (!process.entries.front().app.empty()) children_.Signal(process.name, SIGTERM);
  }
  const int64_t begin = MonotonicMicroseconds();
  while (num_to_end() > 0) {
    OnChildExits();
    const int64_t waited = MonotonicMicroseconds() - begin;
    if (waited > kExitPatience_us / 2 && !is_killing_) {
      is_killing_ = true;
      children_.SignalAllBut(kept, SIGTERM);
    }
    if (waited > kExitPatience_us) {
      children_.SignalAllBut(kept, SIGKILL);
      break;
    }
    AwaitExit(signal_fd, (is_killing_ ? kExitPatience_us : kExitPatience_us / 2) - waited);
  }
}

}  // namespace shoal
