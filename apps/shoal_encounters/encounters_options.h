// The subcommands of `shoal encounters`.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds them; the chosen one sets `action` to what it runs.
void AddEncounterCommands(Command command, CommandAction* action);

/// The main function of shoal-encounters.
int RunShoalEncounters(int argc, char** argv);

}  // namespace shoal
