// The options of `shoal rays`.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds them, and sets `action` to what the command runs.
void AddRaysOptions(Command command, CommandAction* action);

/// The main function of shoal-rays.
int RunShoalRays(int argc, char** argv);

}  // namespace shoal
