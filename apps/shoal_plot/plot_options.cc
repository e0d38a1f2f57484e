#include "apps/shoal_plot/plot_options.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "apps/shoal_plot/plot_command.h"
#include "lib/base/check/result.h"
#include "lib/bus/record/log_commands.h"

namespace shoal {

void AddPlotOptions(CLI::App* command, CommandAction* action) {
  auto options = std::make_shared<PlotOptions>();
  command->add_option("LOG", options->log, "LCM event log")->required();
  command->add_option("--out", options->out_dir,
                      "Folder for the figures; default: plots, beside LOG");
  CLI::Option* mission =
      command->add_option("--mission", options->mission_file,
                          "Mission file; default: mission.toml beside LOG, if there");
  command
      ->add_option("--set", options->overrides, "Override a key of the mission file, as in the run")
      ->take_all()
      ->allow_extra_args(false)
      ->needs(mission);
  command->add_option("--vehicle", options->vehicles, "Only these vehicles")->take_all();
  command->add_option("--from", options->from_s, "From this time on, seconds");
  command->add_option("--to", options->to_s, "Up to this time, seconds");
  command->add_flag("--png", options->png, "PNG instead of SVG");
  command->add_flag("--keep", options->keep, "Leave data and gnuplot scripts in OUT/gnuplot");
  command->callback([options, action] {
    *action = [options] {
      const LogSelection selection{.from_s = options->from_s, .to_s = options->to_s};
      if (!IsSelectionSound(selection, std::cerr)) return static_cast<int>(kExitUsage);
      const char* path = std::getenv("PATH");
      options->search_path = path == nullptr ? "" : path;
      return RunPlot(*options, std::cout, std::cerr);
    };
  });
}

}  // namespace shoal
