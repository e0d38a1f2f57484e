// One mission's part on a host: its files, ports, processes and relay, from the offer to the end.
//
//   Begin: write files -> load -> start processes
//   RUNNING --End(): home is done, or lost--> ENDING: asks the processes, kills after 1 s -->
//   over()
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lib/bus/bus/lcm_transport.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/run/hosts/host_offer.h"
#include "lib/run/hosts/host_relay.h"
#include "lib/run/launch/child_processes.h"
#include "lib/run/launch/launch_plan.h"
#include "lib/run/launch/launch_terminal.h"
#include "lib/run/run/wake_rule.h"

namespace shoal {

class HostSession {
 public:
  using SendHome = std::function<void(const LinkMessage& message)>;

  /// `terminal` must outlive this. `port_base`: of a block for as many vehicles as a mission can
  /// have communities, which this process has claimed.
  HostSession(HostOffer offer, int64_t mission_id, SendHome send, LaunchTerminal& terminal,
              int port_base);
  ~HostSession();
  HostSession(const HostSession&) = delete;
  HostSession& operator=(const HostSession&) = delete;

  /// Loads the mission and starts the processes. Returns why not, or an empty text.
  /// `allow_programs`: participants may have commands of the mission's own.
  [[nodiscard]] std::string Begin(bool allow_programs);

  /// Takes a message of home's; returns what is wrong with it, or an empty text.
  std::string OnMessage(const LinkMessage& message, int64_t wall_us);
  /// Does what is due.
  void OnTime(int64_t wall_us);
  /// Notices which processes have ended; to be called on SIGCHLD.
  void OnExits(int64_t wall_us);
  /// Waits for `timeout_us`, for `extra_fd`, or for what the relay has to act on, and reads the
  /// bus. Returns true where `extra_fd` is readable.
  bool Poll(int64_t timeout_us, int extra_fd);
  int64_t NextDeadline() const;

  /// Lets the processes end.
  void End(int64_t wall_us);
  /// True where End was called and no process is left.
  bool over() const { return is_ending_ && children_.num_running() == 0; }

  const HostOffer& offer() const { return offer_; }
  const Mission& mission() const { return mission_; }
  int64_t mission_id() const { return mission_id_; }
  int64_t step() const { return relay_ == nullptr ? -1 : relay_->step(); }

 private:
  std::string Load();
  std::string ChooseProcesses(bool allow_programs);
  std::string StartAll();
  std::string Start(const RosterProcess& process);
  const RosterProcess* Find(const std::string& name) const;

  const HostOffer offer_;
  const int64_t mission_id_;
  const SendHome send_;
  LaunchTerminal& terminal_;
  const int port_base_;
  RunOptions options_;
  Mission mission_;
  std::vector<RosterProcess> processes_;
  std::unique_ptr<PortPlan> plan_;
  std::unique_ptr<LaunchContext> context_;
  FileDescriptor secret_fd_;
  LcmTransport transport_;
  WakeRule wake_rule_;
  std::unique_ptr<HostRelay> relay_;
  ChildProcesses children_;
  std::string files_folder_;
  bool is_registered_ = false;
  bool is_ending_ = false;
  bool is_killing_ = false;
  int64_t end_us_ = 0;
};

}  // namespace shoal
