// shoal-campaign, which `shoal campaign` becomes: many trials of one mission.
#include "apps/shoal_campaign/campaign_options.h"
#include "lib/run/command_line/tool_commands.h"

int main(int argc, char** argv) {
  return shoal::RunToolCommand("campaign", argc, argv, shoal::AddCampaignCommands);
}
