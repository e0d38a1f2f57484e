// The subcommands of `shoal campaign`.
#pragma once

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds them; the chosen one sets `action` to what it runs.
void AddCampaignCommands(Command command, CommandAction* action);

/// The main function of shoal-campaign.
int RunShoalCampaign(int argc, char** argv);

}  // namespace shoal
