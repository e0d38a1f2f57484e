// The subcommands of `shoal log`.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds them; the chosen one sets `action` to what it runs.
void AddLogCommands(Command command, CommandAction* action);

}  // namespace shoal
