// The options of `shoal rebroker`.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds them, and sets `action` to what the command runs.
void AddRebrokerOptions(Command command, CommandAction* action);

/// The main function of shoal-rebroker.
int RunShoalRebroker(int argc, char** argv);

}  // namespace shoal
