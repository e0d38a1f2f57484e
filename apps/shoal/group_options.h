// `shoal group`: the process in which several participants of a mission run
// (lib/run/run/grouping.h). `shoal run --grouping` starts it.
#pragma once

#include <string>

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds the option --grouping, with a text that ParseGrouping reads.
Option AddGrouping(Command command, std::string* grouping);

/// Adds the command; where it is chosen, it sets `action` to what it runs.
void AddGroup(Command shoal, CommandAction* action);

}  // namespace shoal
