// The options of `shoal import`.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds them, and sets `action` to what the command runs.
void AddImportOptions(Command command, CommandAction* action);

/// The main function of shoal-import.
int RunShoalImport(int argc, char** argv);

}  // namespace shoal
