// `shoal run`: starts a mission's processes, steps them, watches over them, and cleans up.
//
//   claim ports -> start processes -> wait for hellos -> step until the last -> END -> summary
//        |               |                 |                   |
//        +---------------+---- an error ---+-- loss, Ctrl-C ---+--> END (or kill) -> exit code
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "lib/bus/lcm_transport.h"
#include "lib/launch/child_processes.h"
#include "lib/launch/launch_plan.h"
#include "lib/mission/mission.h"
#include "lib/run/director.h"
#include "lib/run/roster.h"
#include "lib/run/step_clock.h"
#include "lib/run/step_participant.h"

namespace shoal {

/// Runs the mission to its end. Returns the exit code (lib/check/result.h). Prints progress and
/// summary to standard output, trouble to standard error.
int RunMission(const RunOptions& options, const Mission& mission,
               const MakeDirector& make_director);

class Launcher {
 public:
  /// `ports` must be claimed. Nothing is started yet.
  Launcher(const RunOptions& options, const Mission& mission, const MakeDirector& make_director,
           PortPlan ports, int64_t mission_id, std::string log_dir);

  /// `signal_fd`: a signalfd for SIGINT, SIGTERM, SIGHUP and SIGCHLD.
  int Run(int signal_fd);

 private:
  std::string HandCommand(const RosterEntry& entry) const;
  bool StartAll();
  bool StartOne(const RosterEntry& entry);
  bool StartViewer();
  void AnnounceViewer(int64_t wall_us);
  void Loop(int signal_fd);
  void OnSignals(int signal_fd);
  void OnChildExits();
  void CheckSilence(int64_t wall_us);
  void CheckGathering(int64_t wall_us);
  void CheckFaults(int64_t wall_us);
  void OnLost(const std::string& name, const std::string& how,
              const std::vector<std::string>& last_lines);
  void Fail(int exit_code, const std::string& why);
  void Say(const std::string& line);
  void ShowLine(const std::string& line);
  void ShowProgress(int64_t wall_us);
  void EndChildren();
  int Conclude();

  const RunOptions& options_;
  const Mission& mission_;
  const PortPlan ports_;
  const LaunchContext context_;
  const std::vector<RosterEntry> roster_;
  ChildProcesses children_;
  LcmTransport transport_;
  StepParticipant participant_;
  std::unique_ptr<Director> director_;
  StepClock clock_;
  std::set<std::string> lost_;  ///< Named already; not to be named again.
  std::map<std::string, int> num_restarts_;
  std::vector<std::string> loggers_;
  std::string viewer_log_;  ///< Where the viewer tells its address; empty: it has told.
  int64_t next_look_for_viewer_us_ = 0;
  bool interrupted_ = false;
  int exit_code_ = 0;             ///< Not 0: something other than the verdict decided.
  int64_t started_us_ = 0;        ///< When the children were started.
  int64_t running_since_us_ = 0;  ///< When the first step began; 0: not yet.
  int64_t ended_us_ = 0;
  int64_t next_progress_us_ = 0;
  bool progress_shown_ = false;
  int64_t next_waiting_line_us_ = 0;
  bool told_foreign_ = false;
  bool told_stranger_ = false;
  bool killing_ = false;  ///< Those who still run have been told to go.
};

}  // namespace shoal
