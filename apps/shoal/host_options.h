// The command line of `shoal host`.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds `shoal host` and its subcommand; the chosen one sets `action`.
void AddHostCommands(Command shoal, CommandAction* action);

}  // namespace shoal
