// The subcommands of `shoal log` that write a log in formats of other systems.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds them; the chosen one sets `action` to what it runs.
void AddLogExportCommands(Command log, CommandAction* action);

/// The main function of shoal-log-export.
int RunShoalLogExport(int argc, char** argv);

}  // namespace shoal
