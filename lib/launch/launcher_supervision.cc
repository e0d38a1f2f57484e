// Launcher: watches over the processes that it has started, from the wait for their hellos to their
// exits: losses, restarts, signals, faults of the bus.
#include <fmt/format.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "lib/check/time_units.h"
#include "lib/launch/launcher.h"
#include "lib/run/run_app.h"

namespace shoal {

namespace {

constexpr int64_t kPatience_us = 700'000;        ///< For the step under way when the end is wanted.
constexpr int64_t kExitPatience_us = 1'000'000;  ///< For processes to leave after END.
constexpr int64_t kStartPatience_us = 20 * kSecond_us;
constexpr int64_t kWaitingLine_us = 10 * kSecond_us;     ///< While somebody has to start something.
constexpr int64_t kViewerPatience_us = 10 * kSecond_us;  ///< For the viewer to tell its address.
constexpr int64_t kViewerLook_us = 100'000;
constexpr int kMaxRestarts = 5;  ///< Of one participant; more is a crash loop.

constexpr char kViewer[] = "shoal-viewer";

/// Returns the line that tells the viewer's address, once it is there as a whole.
std::string AddressIn(const std::string& log_path) {
  std::ifstream in(log_path);
  for (std::string line; std::getline(in, line) && !in.eof();) {
    if (line.starts_with("viewer: http")) return line;
  }
  return {};
}

}  // namespace

void Launcher::OnSignals(int signal_fd) {
  signalfd_siginfo info{};
  while (read(signal_fd, &info, sizeof info) == sizeof info) {
    if (info.ssi_signo == SIGCHLD) continue;  // Several may share one; Reap finds all.
    if (interrupted_) {
      killing_ = true;  // Asked twice: no more patience.
      children_.SignalAll(SIGKILL);
    } else {
      interrupted_ = true;
      Fail(kExitMissionFailed, "interrupted: ending the mission");
    }
  }
  OnChildExits();
}

void Launcher::OnChildExits() {
  for (const ChildExit& exit : children_.Reap()) {
    const bool is_logger = std::find(loggers_.begin(), loggers_.end(), exit.name) != loggers_.end();
    const bool is_over = clock_.state() == StepClock::State::kEnded;
    if (exit.name == kViewer) {
      viewer_log_.clear();
      if (is_over || killing_) continue;
      Say(fmt::format("{} {}; the mission goes on", exit.name, exit.how));
      for (const std::string& line : exit.last_lines) Say("    " + line);
    } else if (killing_ || ((is_logger || is_over) && exit.clean)) {
      clock_.Drop(exit.name, MonotonicMicroseconds());
    } else if (is_logger) {
      Say(fmt::format("{} {}; the recorder goes on", exit.name, exit.how));
    } else if (is_over) {
      Say(fmt::format("{} {} after the end", exit.name, exit.how));
    } else if (clock_.state() == StepClock::State::kEnding && exit.clean) {
      clock_.Leave(exit.name, MonotonicMicroseconds());
    } else {
      OnLost(exit.name, fmt::format("{} (pid {}) {}", exit.name, exit.pid, exit.how),
             exit.last_lines);
    }
  }
}

void Launcher::CheckSilence(int64_t wall_us) {
  for (const std::string& name : clock_.Silent(wall_us)) {
    children_.Signal(name, SIGKILL);
    OnLost(name,
           fmt::format("{} has not answered step {} for {} s of wall time (stopped, or hung)", name,
                       clock_.step(), mission_.participant_timeout_s),
           {});
  }
}

void Launcher::OnLost(const std::string& name, const std::string& how,
                      const std::vector<std::string>& last_lines) {
  const bool is_new = lost_.insert(name).second;
  if (is_new) {
    Say("LOST: " + how);
    for (const std::string& line : last_lines) Say("    " + line);
  }
  const bool is_running = clock_.state() == StepClock::State::kRunning;
  clock_.Drop(name, MonotonicMicroseconds());
  if (exit_code_ != 0) return;
  // A second recorder would empty the log of the first, and none would leave it cut.
  if (mission_.on_loss == OnLoss::kEnd || !is_running || name == "recorder") {
    Fail(kExitEnvironment, fmt::format("the mission ends without {}", name));
    return;
  }
  const auto entry = std::find_if(roster_.begin(), roster_.end(),
                                  [&](const RosterEntry& each) { return each.name == name; });
  const bool restarts = mission_.on_loss == OnLoss::kRestart && entry != roster_.end() &&
                        entry->provider == Provider::kShoal;
  if (!restarts) {
    if (is_new) Say(fmt::format("the mission goes on without {}", name));
  } else if (children_.IsRunning(name)) {
    return;  // It has been killed; its exit comes next.
  } else if (++num_restarts_[name] > kMaxRestarts) {
    Fail(kExitEnvironment, fmt::format("{} was restarted {} times already", name, kMaxRestarts));
  } else if (StartOne(*entry)) {
    lost_.erase(name);
    Say(fmt::format("{} starts again", name));
  }
}

void Launcher::CheckGathering(int64_t wall_us) {
  if (clock_.state() == StepClock::State::kRunning && running_since_us_ == 0) {
    running_since_us_ = wall_us;
  }
  if (clock_.state() != StepClock::State::kGathering) return;
  if (exit_code_ != 0) return;
  const std::vector<std::string> awaited = clock_.Awaited();
  const bool tells = wall_us >= next_waiting_line_us_;
  if (tells) next_waiting_line_us_ = wall_us + kWaitingLine_us;
  for (const RosterEntry& entry : roster_) {
    if (std::find(awaited.begin(), awaited.end(), entry.name) == awaited.end()) continue;
    if (entry.provider == Provider::kHand) {
      if (tells) Say(fmt::format("waiting for {}: {}", entry.name, HandCommand(entry)));
    } else if (wall_us - started_us_ > kStartPatience_us) {
      Fail(kExitEnvironment,
           fmt::format("{} did not report within {} s; its output: {}/{}.txt", entry.name,
                       kStartPatience_us / kSecond_us, context_.log_dir, entry.name));
      return;
    }
  }
}

bool Launcher::StartViewer() {
  const Result<ChildCommand> command = ViewerCommand(context_);
  if (!command.ok()) {
    Fail(kExitEnvironment, command.error());
    return false;
  }
  const Result<pid_t> pid = children_.Start(*command);
  if (!pid.ok()) {
    Fail(kExitEnvironment, pid.error());
    return false;
  }
  viewer_log_ = command->log_path;
  return true;
}

/// Prints the viewer's address once the viewer has told it.
void Launcher::AnnounceViewer(int64_t wall_us) {
  if (viewer_log_.empty() || wall_us < next_look_for_viewer_us_) return;
  next_look_for_viewer_us_ = wall_us + kViewerLook_us;
  const std::string address = AddressIn(viewer_log_);
  if (address.empty() && wall_us - started_us_ < kViewerPatience_us) return;
  if (address.empty()) {
    Say(fmt::format("the viewer has not told its address yet; its output: {}", viewer_log_));
  } else {
    ShowLine(address);
  }
  viewer_log_.clear();
}

void Launcher::CheckFaults(int64_t wall_us) {
  if (!clock_.fault().empty() && exit_code_ == 0) {
    std::string why = clock_.fault();
    if (why.find("never reached") != std::string::npos) {
      constexpr int kUsefulReceiveBuffer = 4'194'304;
      why += "\nThe bus loses messages for good: --warp is more than this machine can, ";
      why += ReceiveBufferLimit() < kUsefulReceiveBuffer
                 ? fmt::format(
                       "or the receive buffer is too small (now {} bytes):\n    sudo sysctl "
                       "-w net.core.rmem_max={}\n",
                       ReceiveBufferLimit(), kUsefulReceiveBuffer)
                 : std::string("or somebody floods its ports. ");
      why += "`shoal doctor` looks for more.";
    }
    Fail(kExitEnvironment, why);
  }
  if (!told_stranger_ && !clock_.stranger().empty()) {
    told_stranger_ = true;
    Say(fmt::format("{} speaks the step protocol, but this mission has no such participant; it {}",
                    clock_.stranger(),
                    clock_.Awaited().empty()
                        ? "waits for nobody"
                        : fmt::format("waits for {}", fmt::join(clock_.Awaited(), ", "))));
  }
  if (!told_foreign_ && clock_.counters().foreign + participant_.num_foreign() > 0) {
    told_foreign_ = true;
    Say(
        fmt::format("messages of another mission arrive on ports {} to {} and are rejected: choose "
                    "other ports with --port",
                    ports_.base(), ports_.base() + ports_.num_ports() - 1));
  }
  if (exit_code_ != 0) clock_.Stop(wall_us, kPatience_us);
}

void Launcher::EndChildren() {
  // lcm-logger ends on SIGINT. Shoal's own have answered END, or hear now that it is over; a user's
  // get the time to leave by themselves.
  children_.Signal(kViewer, SIGTERM);
  for (const std::string& name : loggers_) children_.Signal(name, SIGINT);
  for (const RosterEntry& entry : roster_) {
    if (!entry.app.empty()) children_.Signal(entry.name, SIGTERM);
  }
  const int64_t begin = MonotonicMicroseconds();
  while (children_.num_running() > 0) {
    OnChildExits();
    const int64_t waited = MonotonicMicroseconds() - begin;
    if (waited > kExitPatience_us / 2 && !killing_) {
      killing_ = true;
      children_.SignalAll(SIGTERM);
    }
    if (waited > kExitPatience_us) {
      children_.SignalAll(SIGKILL);
      break;
    }
    usleep(2'000);
  }
}

}  // namespace shoal
