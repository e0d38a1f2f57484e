#include "apps/shoal_plot/plot_options.h"

#include <cstdlib>
#include <iostream>
#include <memory>

#include "apps/shoal_plot/plot_command.h"
#include "lib/base/check/result.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_reader.h"
#include "lib/run/command_line/tool_commands.h"

namespace shoal {

void AddPlotOptions(Command command, CommandAction* action) {
  auto options = std::make_shared<PlotOptions>();
  command.AddOption("LOG", &options->log, "LCM event log, or the folder of a recording").Required();
  command.AddOption("--out", &options->out_dir,
                    "Folder for the figures; default: plots, beside LOG");
  const Option mission =
      command.AddOption("--mission", &options->mission_file,
                        "Mission file; default: mission.toml beside LOG, if there");
  command
      .AddOption("--set", &options->overrides, "Override a key of the mission file, as in the run")
      .Repeatable()
      .Needs(mission);
  command.AddOption("--vehicle", &options->vehicles, "Only these vehicles").TakeAll();
  command.AddOption("--from", &options->from_s, "From this time on, seconds");
  command.AddOption("--to", &options->to_s, "Up to this time, seconds");
  command.AddFlag("--png", &options->png, "PNG instead of SVG");
  command.AddFlag("--keep", &options->keep, "Leave data and gnuplot scripts in OUT/gnuplot");
  command.Callback([options, action] {
    *action = [options] {
      options->log = LogFileOf(options->log);
      const LogSelection selection{.from_s = options->from_s, .to_s = options->to_s};
      if (!IsSelectionSound(selection, std::cerr)) return static_cast<int>(kExitUsage);
      const char* path = std::getenv("PATH");
      options->search_path = path == nullptr ? "" : path;
      return RunPlot(*options, std::cout, std::cerr);
    };
  });
}

int RunShoalPlot(int argc, char** argv) {
  return RunToolCommand("plot", argc, argv, AddPlotOptions);
}

}  // namespace shoal
