// `shoal run`: starts a mission's processes, steps them, and sums up. lib/run/launch/supervision.h
// watches over them.
//
//   claim ports -> start processes -> wait for hellos -> step until the last -> END -> summary
//        |               |                 |                   |
//        +---------------+---- an error ---+-- loss, Ctrl-C ---+--> END (or kill) -> exit code
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/bus/bus/lcm_transport.h"
#include "lib/mission/model/mission.h"
#include "lib/run/launch/launch_plan.h"
#include "lib/run/launch/launch_terminal.h"
#include "lib/run/launch/supervision.h"
#include "lib/run/run/grouping.h"
#include "lib/run/run/launched_apps.h"
#include "lib/run/run/step_clock.h"
#include "lib/run/run/step_group.h"
#include "lib/run/run/wake_rule.h"

namespace shoal {

/// Runs the mission to its end. Returns the exit code (lib/base/check/result.h). Prints progress
/// and summary to standard output, trouble to standard error.
int RunMission(const RunOptions& options, const Mission& mission, const LaunchedApps& apps);

class Launcher {
 public:
  /// `ports` must be claimed. `access` is given if the mission has hosts that run
  /// something. No process starts before Run().
  Launcher(const RunOptions& options, const Mission& mission, const LaunchedApps& apps,
           PortPlan ports, int64_t mission_id, const MissionSecret& secret, int secret_fd,
           std::string log_dir, std::optional<HostAccess> access);

  /// `signal_fd`: a signalfd for SIGINT, SIGTERM, SIGHUP and SIGCHLD.
  int Run(int signal_fd);

 private:
  void Loop(int signal_fd);
  void ShowProgress(int64_t wall_us);
  int Conclude();
  /// Writes the verdict for viewers, and into the recording.
  void LeaveVerdict(bool complete);

  const RunOptions& options_;
  const Mission& mission_;
  const PortPlan ports_;
  const LaunchContext context_;
  const std::vector<RosterProcess> processes_;
  LcmTransport transport_;
  WakeRule wake_rule_;
  StepGroup group_;  ///< Of the director alone.
  std::unique_ptr<Director> director_;
  StepClock clock_;
  LaunchTerminal terminal_;
  std::unique_ptr<MissionHosts> hosts_;  ///< Null: all runs on this computer.
  Supervision supervision_;
  int64_t running_since_us_ = 0;  ///< When the first step began; 0: not yet.
  int64_t ended_us_ = 0;
  int64_t next_progress_us_ = 0;
};

}  // namespace shoal
