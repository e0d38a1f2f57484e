// The command line of `shoal`, which its programs share: `shoal` itself and those that it starts
// for a command, as `shoal-campaign` for `shoal campaign` (tool_commands.h).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lib/run/command_line/command.h"

namespace shoal {

/// What the chosen command does; returns the exit code.
using CommandAction = std::function<int()>;

/// Returns the command `shoal`, with what --help and --version of it print, without commands.
[[nodiscard]] Program MakeShoalCommand();

/// Parses `words`, the first of which is the program's name, and calls `*action`, which the chosen
/// command has set. Returns the exit code; kExitUsage, with an error, where the command line is
/// wrong; kExitEnvironment, with an error, where what was printed could not be written.
int RunCommandLine(Program& shoal, const CommandAction* action,
                   const std::vector<std::string>& words);

}  // namespace shoal
