// The subcommands of `shoal log`.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds them; the chosen one sets `action` to what it runs.
void AddLogCommands(Command command, CommandAction* action);

/// The main function of shoal-log.
int RunShoalLog(int argc, char** argv);

}  // namespace shoal
