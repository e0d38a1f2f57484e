#include "apps/shoal_rebroker/rebroker_options.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "apps/shoal_rebroker/rebroker_command.h"

namespace shoal {

void AddRebrokerOptions(CLI::App* command, CommandAction* action) {
  auto options = std::make_shared<RebrokerOptions>();
  command->add_option("LOG", options->logs, "LCM event log; several: of loggers of one mission")
      ->required();
  command->add_option("--comms", options->comms_file,
                      "Rules: a mission file, or one with [comms] alone; default: the recorded");
  command->add_option("--log", options->out_path,
                      "Write what is delivered by these rules as an LCM log");
  command->add_flag("--no-controls", options->no_controls, "Leave out what was published on UNC_*");
  command->add_flag("--all", options->all_links, "Show all links, however many there are");
  command->add_flag("--skip-damage", options->skip_damage, "Read what can be read of a bad log");
  command->callback([options, action] {
    *action = [options] { return RunRebroker(*options, std::cout, std::cerr); };
  });
}

}  // namespace shoal
