// Which processes a mission needs, and with which command lines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/layout.h"
#include "lib/bus/record/channel_choice.h"
#include "lib/mission/model/mission.h"
#include "lib/run/launch/child_processes.h"
#include "lib/run/launch/viewer_arguments.h"
#include "lib/run/run/grouping.h"
#include "lib/run/run/roster.h"

namespace shoal {

/// What `shoal run` was asked for.
struct RunOptions {
  std::string mission_file;
  std::vector<std::string> overrides;
  double warp = 1;               ///< 0: as fast as possible.
  std::optional<Layout> layout;  ///< Absent: PortPlan::Suggest.
  int port_base = 0;             ///< 0: the first free block.
  std::string record_dir;        ///< Empty: no recording.
  /// Its log is mission.lcm.zst; absent: where it is expected to be large (lib/run/run/log_plan.h).
  std::optional<bool> compress = std::nullopt;
  ChannelChoice log_channels = {};
  bool lcm_logger = false;  ///< Stock lcm-logger on each bus, beside the recorder.
  Grouping grouping = {};   ///< How participants share processes.
  double lose = 0;          ///< Fault injection, handed to every participant.
  std::string lose_forever = {};
  bool quiet = false;               ///< No progress line.
  std::optional<ViewOptions> view;  ///< A viewer beside the mission.
  std::string key_file = {};        ///< This computer's key, for hosts; empty: HostKeyPath().
};

/// A mission's place on this machine.
struct LaunchContext {
  const RunOptions& options;
  const Mission& mission;
  const PortPlan& ports;
  int64_t mission_id = 0;
  int secret_fd = -1;    ///< A file with the mission's secret, for the participants.
  std::string log_dir;   ///< For the processes' output.
  std::string log_path;  ///< Of the recorder; empty: no recording.
};

/// Returns the command of a process that the launcher starts. The error names the program that
/// cannot be found, and where it was looked for.
[[nodiscard]] Result<ChildCommand> CommandOf(const RosterProcess& process,
                                             const LaunchContext& context);

/// Returns an error for each of the processes that is started here and whose program is missing.
/// (A group runs in shoal's own program.)
std::vector<std::string> MissingPrograms(const Mission& mission,
                                         const std::vector<RosterProcess>& processes);

/// Returns variables, as ParticipantEnvironment has them, as a shell takes them before a command.
std::string ShellVariables(const std::vector<std::string>& variables);

/// Returns the command line for a participant that a user starts.
std::string HandCommand(const RosterEntry& entry, const LaunchContext& context);

/// Returns the commands of lcm-logger, one per bus.
[[nodiscard]] Result<std::vector<ChildCommand>> LcmLoggerCommands(const LaunchContext& context);

/// Returns the command of the viewer that options.view asks for. @pre options.view
[[nodiscard]] Result<ChildCommand> ViewerCommand(const LaunchContext& context);

/// Returns the environment of a process by its name, as "SHOAL_PORT=7665" and so on;
/// docs/extending/step_protocol.md. One that the launcher starts has SHOAL_SECRET_FD too.
std::vector<std::string> ParticipantEnvironment(const std::string& name,
                                                const LaunchContext& context);

}  // namespace shoal
