// The command line of `shoal play`.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

void AddPlayOptions(Command command, CommandAction* action);

/// The main function of shoal-play.
int RunShoalPlay(int argc, char** argv);

}  // namespace shoal
