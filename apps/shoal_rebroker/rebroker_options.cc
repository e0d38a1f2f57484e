#include "apps/shoal_rebroker/rebroker_options.h"

#include <iostream>
#include <memory>

#include "apps/shoal_rebroker/rebroker_command.h"
#include "lib/run/command_line/tool_commands.h"

namespace shoal {

void AddRebrokerOptions(Command command, CommandAction* action) {
  auto options = std::make_shared<RebrokerOptions>();
  command.AddOption("LOG", &options->logs, "LCM event log; several: of loggers of one mission")
      .Required();
  command.AddOption("--comms", &options->comms_file,
                    "Rules: a mission file, or one with [comms] alone; default: the recorded");
  command.AddOption("--log", &options->out_path,
                    "Write what is delivered by these rules as an LCM log");
  command.AddFlag("--no-controls", &options->no_controls, "Leave out what was published on UNC_*");
  command.AddFlag("--all", &options->all_links, "Show all links, however many there are");
  command.AddFlag("--skip-damage", &options->skip_damage, "Read what can be read of a bad log");
  command.Callback([options, action] {
    *action = [options] { return RunRebroker(*options, std::cout, std::cerr); };
  });
}

int RunShoalRebroker(int argc, char** argv) {
  return RunToolCommand("rebroker", argc, argv, AddRebrokerOptions);
}

}  // namespace shoal
