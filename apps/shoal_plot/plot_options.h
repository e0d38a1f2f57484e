// The options of `shoal plot`.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds them, and sets `action` to what the command runs.
void AddPlotOptions(Command command, CommandAction* action);

/// The main function of shoal-plot.
int RunShoalPlot(int argc, char** argv);

}  // namespace shoal
