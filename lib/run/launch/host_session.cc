#include "lib/run/launch/host_session.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "lib/base/text/terminal_text.h"
#include "lib/base/time/time_units.h"
#include "lib/bus/bus/layout.h"
#include "lib/run/run/run_app.h"
#include "lib/run/run/run_folder.h"
#include "lib/run/run/run_registry.h"

namespace shoal {

namespace {

constexpr int64_t kEndPatience_us = kSecond_us;

}  // namespace

HostSession::HostSession(HostOffer offer, int64_t mission_id, SendHome send,
                         LaunchTerminal& terminal, int port_base)
    : offer_(std::move(offer)),
      mission_id_(mission_id),
      send_(std::move(send)),
      terminal_(terminal),
      port_base_(port_base),
      wake_rule_(std::min(kWantedReceiveBuffer, ReceiveBufferLimit()), WakeRule::kFewOfRelay) {}

HostSession::~HostSession() {
  children_.SignalAll(SIGKILL);
  if (is_registered_) Unregister(port_base_);
  std::error_code error;
  if (!files_folder_.empty()) std::filesystem::remove_all(files_folder_, error);
}

std::string HostSession::Begin(bool allow_programs) {
  if (std::string why = Load(); !why.empty()) return why;
  if (std::string why = ChooseProcesses(allow_programs); !why.empty()) return why;
  return StartAll();
}

std::string HostSession::Load() {
  const Result<std::string> folder = MakeRunSubfolder(fmt::format("{}-mission", port_base_));
  if (!folder.ok()) return folder.error();
  files_folder_ = *folder;
  Result<Mission> mission = LoadOffered(offer_, files_folder_);
  if (!mission.ok()) return mission.error();
  mission_ = std::move(*mission);
  return {};
}

std::string HostSession::ChooseProcesses(bool allow_programs) {
  const auto roster = OfferedRoster(offer_, mission_, allow_programs);
  if (!roster.ok()) return roster.error();
  processes_ = ShareOut(*roster, offer_.grouping);  // Groups have the names that they have at home.
  for (RosterProcess& process : processes_) {
    for (RosterEntry& entry : process.entries) entry.host.clear();  // It runs on this computer.
  }
  const std::vector<std::string> missing = MissingPrograms(mission_, processes_);
  return missing.empty() ? std::string() : missing.front();
}

std::string HostSession::StartAll() {
  plan_ = std::make_unique<PortPlan>(port_base_, offer_.layout, VehicleNames(mission_));
  const RunningMission running{.name = mission_.name,
                               .file = mission_.file,
                               .folder = files_folder_,  // `shoal send` means home's.
                               .mission_id = mission_id_,
                               .port_base = port_base_,
                               .layout = offer_.layout,
                               .grouping = Name(offer_.grouping),
                               .pid = getpid(),
                               .vehicles = VehicleNames(mission_),
                               .overrides = offer_.overrides,
                               .groups = GroupsOf(mission_),
                               .orders = OrdersOf(mission_)};
  if (const auto kept = KeepSecret(port_base_, offer_.secret); !kept.ok()) return kept.error();
  const Result<int> secret_fd = SecretInMemory(offer_.secret);
  if (!secret_fd.ok()) return secret_fd.error();
  secret_fd_ = FileDescriptor(*secret_fd);
  if (const auto registered = Register(running); !registered.ok()) return registered.error();
  is_registered_ = true;
  const Result<std::string> log_dir = MakeRunSubfolder(fmt::format("{}-logs", port_base_));
  if (!log_dir.ok()) return log_dir.error();
  options_.mission_file = mission_.file;
  options_.overrides = offer_.overrides;
  options_.grouping = offer_.grouping;
  context_ = std::make_unique<LaunchContext>(LaunchContext{.options = options_,
                                                           .mission = mission_,
                                                           .ports = *plan_,
                                                           .mission_id = mission_id_,
                                                           .secret_fd = secret_fd_.get(),
                                                           .log_dir = *log_dir,
                                                           .log_path = {}});
  relay_ = std::make_unique<HostRelay>(
      RelayOptions{.name = "host", .mission_id = mission_id_, .secret = offer_.secret}, *plan_,
      transport_,
      std::set<std::string, std::less<>>(offer_.participants.begin(), offer_.participants.end()),
      send_);
  transport_.DeferFrom(plan_->shore_port());
  transport_.set_receiver(
      [this](int port, std::string_view channel, std::span<const uint8_t> datagram) {
        wake_rule_.OnDatagram();
        relay_->OnDatagram(port, channel, datagram, MonotonicMicroseconds());
      });
  if (!transport_.error().empty()) return transport_.error();
  for (const RosterProcess& process : processes_) {
    const RosterEntry& entry = process.entries.front();
    if (entry.provider == Provider::kHand) {
      terminal_.Show(fmt::format("waiting for {}: {}", entry.name,
                                 TerminalLine(HandCommand(entry, *context_))));
    } else if (std::string why = Start(process); !why.empty()) {
      return why;
    }
  }
  return {};
}

std::string HostSession::Start(const RosterProcess& process) {
  const Result<ChildCommand> command = CommandOf(process, *context_);
  if (!command.ok()) return command.error();
  const Result<pid_t> pid = children_.Start(*command);
  return pid.ok() ? std::string() : pid.error();
}

const RosterProcess* HostSession::Find(const std::string& name) const {
  const auto found = std::find_if(processes_.begin(), processes_.end(),
                                  [&](const RosterProcess& each) { return each.name == name; });
  return found == processes_.end() ? nullptr : &*found;
}

std::string HostSession::OnMessage(const LinkMessage& message, int64_t wall_us) {
  const std::string name = message.TextOf("name");
  switch (message.kind) {
    case LinkKind::kTick:
      wake_rule_.OnStep(wall_us);
      return relay_->OnMessage(message, wall_us);
    case LinkKind::kAside:
      return relay_->OnMessage(message, wall_us);
    case LinkKind::kStart: {
      const RosterProcess* process = Find(name);
      const bool is_ours =
          process != nullptr && process->entries.front().provider != Provider::kHand;
      if (!is_ours || is_ending_) return {};
      if (children_.IsRunning(name)) return fmt::format("a start of {}, which runs", name);
      terminal_.Show(fmt::format("{} starts again", name));
      return Start(*process);
    }
    case LinkKind::kSignal: {
      const int signal = std::atoi(message.TextOf("signal").c_str());
      if (signal < 1 || signal > SIGSYS) return fmt::format("a signal of number {}", signal);
      if (Find(name) != nullptr) children_.Signal(name, signal);
      return {};
    }
    case LinkKind::kEnd:
      End(wall_us);
      return {};
    default:
      return {};
  }
}

void HostSession::OnTime(int64_t wall_us) {
  relay_->OnTime(wall_us);
  if (is_ending_ && !is_killing_ && wall_us >= end_us_) {
    is_killing_ = true;
    children_.SignalAll(SIGKILL);
  }
}

void HostSession::OnExits(int64_t wall_us) {
  for (const ChildExit& exit : children_.Reap()) {
    if (const RosterProcess* process = Find(exit.name)) {
      for (const RosterEntry& entry : process->entries) relay_->Forget(entry.name, wall_us);
    }
    if (!exit.clean && !is_ending_) {
      terminal_.Warn(fmt::format("LOST: {} (pid {}) {}", exit.name, exit.pid, exit.how));
      for (const std::string& line : exit.last_lines) terminal_.Warn("    " + line);
    }
    send_(ToLinkMessage(HostExit{.name = exit.name,
                                 .pid = exit.pid,
                                 .clean = exit.clean,
                                 .how = exit.how,
                                 .last_lines = exit.last_lines},
                        mission_id_));
  }
}

bool HostSession::Poll(int64_t timeout_us, int extra_fd) {
  const int64_t now = MonotonicMicroseconds();
  const bool sleeps = !relay_->awaits_data() && wake_rule_.SleepsThrough(now);
  return transport_.Poll(sleeps ? wake_rule_.Timeout(timeout_us, now) : timeout_us, extra_fd,
                         sleeps ? WakeFor::kSteps : WakeFor::kAll);
}

int64_t HostSession::NextDeadline() const {
  return is_ending_ ? std::min(end_us_, relay_->NextDeadline()) : relay_->NextDeadline();
}

void HostSession::End(int64_t wall_us) {
  if (is_ending_) return;
  is_ending_ = true;
  end_us_ = wall_us + kEndPatience_us;
  children_.SignalAll(SIGTERM);
}

}  // namespace shoal
