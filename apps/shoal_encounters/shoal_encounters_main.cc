// shoal-encounters, which `shoal encounters` becomes: mission files of encounters, and trials of
// many.
#include "apps/shoal_encounters/encounters_options.h"
#include "lib/run/command_line/tool_commands.h"

int main(int argc, char** argv) {
  return shoal::RunToolCommand("encounters", argc, argv, shoal::AddEncounterCommands);
}
