// The processes of a mission, from their start to their exits: losses, restarts, signals, faults of
// the bus.
//
//   start all -> await their hellos -> watch: exits, silence, faults -> end all
//                                        |
//                                        +-- lost --> end the mission, go on without it, restart it
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lib/run/launch/child_processes.h"
#include "lib/run/launch/launch_plan.h"
#include "lib/run/launch/launch_terminal.h"
#include "lib/run/launch/mission_hosts.h"
#include "lib/run/launch/viewer_address.h"
#include "lib/run/run/grouping.h"
#include "lib/run/run/step_clock.h"

namespace shoal {

/// Returns how long the processes that shoal starts may take to report, microseconds of wall time:
/// four times `participant_timeout_s` (at least 5 s of it), and half a second for each process.
int64_t StartLimit_us(double participant_timeout_s, size_t num_processes);

class Supervision {
 public:
  /// How long a mission that is over in seconds waits for a page to be opened.
  static constexpr int64_t kPagePatience_us = 30'000'000;

  /// All arguments must outlive this. `hosts`: nullptr where all runs on this computer.
  Supervision(const LaunchContext& context, const std::vector<RosterProcess>& processes,
              StepClock& clock, LaunchTerminal& terminal, MissionHosts* hosts);

  /// Starts all processes; false after Fail. With `--view` and `--warp max` it first waits for a
  /// page, for kPagePatience_us at most. `signal_fd` as OnSignals has it.
  bool StartAll(int signal_fd);
  /// Reads a signalfd for SIGINT, SIGTERM, SIGHUP and SIGCHLD.
  void OnSignals(int signal_fd);
  /// Does what is due. `num_foreign`: messages of other missions that were rejected so far.
  void OnTime(int64_t wall_us, int64_t num_foreign);
  /// Ends all processes: asks, waits for a second, then kills. A viewer goes on where
  /// ViewerStays().
  void EndAll(int signal_fd);
  /// Returns true where the viewer goes on after the mission: it runs, and the user has not
  /// interrupted the mission.
  bool ViewerStays() const;
  /// Waits until the viewer ends, or a signal for this process ends it.
  void AwaitViewer(int signal_fd);

  /// The mission ends with this exit code; OnTime stops the clock. The first call with
  /// kExitEnvironment is the cause.
  void Fail(int exit_code, const std::string& why);
  /// Names the processes that were lost after the end had been decided, and repeats its cause where
  /// that was the machine's, so that it is the last line as it was the first.
  void ShowCause();
  /// Not 0: something other than the verdict decided.
  int exit_code() const { return exit_code_; }
  /// `name`: of a process.
  bool HasLost(const std::string& name) const {
    return lost_.contains(name) || lost_later_.contains(name);
  }

 private:
  const RosterProcess* ProcessOf(const std::string& participant) const;
  const RosterProcess* FindProcess(const std::string& name) const;
  bool StartProcess(const RosterProcess& process);
  bool Start(const Result<ChildCommand>& command);
  bool StartViewer();
  void AwaitPage(int signal_fd);
  bool StartLoggers();
  void OnChildExits();
  void CheckHosts();
  void OnHostTrouble(const HostTrouble& trouble);
  void CheckGathering(int64_t wall_us);
  void CheckSilence(int64_t wall_us);
  void CheckFaults(int64_t wall_us, int64_t num_foreign);
  /// Fails with the network's fault where it has one; returns whether it has.
  bool FailedByNetwork();
  void OnChildExit(const ChildExit& exit);
  void OnLost(const RosterProcess& process, const std::string& how,
              const std::vector<std::string>& last_lines);
  void Restart(const RosterProcess& process);
  /// Has the clock go on without all participants of the process.
  void Drop(const RosterProcess& process);

  const LaunchContext& context_;
  const std::vector<RosterProcess>& processes_;
  StepClock& clock_;
  LaunchTerminal& terminal_;
  MissionHosts* const hosts_;
  ChildProcesses children_;
  ViewerAddress viewer_address_;
  std::string viewer_log_;  ///< Its output.
  std::vector<std::string> loggers_;
  std::set<std::string> lost_;        ///< Lost processes that the user knows of.
  std::set<std::string> lost_later_;  ///< Lost after the end of the mission was decided.
  std::string cause_;                 ///< Why the mission fails; empty where Fail was not called.
  std::map<std::string, int> num_restarts_;
  int exit_code_ = 0;
  int64_t started_us_ = 0;
  int64_t next_waiting_line_us_ = 0;
  bool is_ending_ = false;  ///< EndAll has asked processes to exit.
  bool is_interrupted_ = false;
  bool is_killing_ = false;  ///< Processes that still run have been signalled to end.
  bool has_shown_foreign_ = false;
  bool has_shown_unregistered_ = false;
  bool has_shown_refused_ = false;
  bool has_shown_paused_ = false;
};

}  // namespace shoal
