// The options of `shoal import`.
#pragma once

#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds them, and sets `action` to what the command runs.
void AddImportOptions(CLI::App* command, CommandAction* action);

}  // namespace shoal
