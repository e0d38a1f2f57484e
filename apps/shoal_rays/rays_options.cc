#include "apps/shoal_rays/rays_options.h"

#include <cstdlib>
#include <iostream>
#include <memory>

#include "apps/shoal_rays/rays_command.h"
#include "lib/run/command_line/tool_commands.h"

namespace shoal {

void AddRaysOptions(Command command, CommandAction* action) {
  auto options = std::make_shared<RaysOptions>();
  command
      .AddOption("FILE", &options->file,
                 "Mission file with [acoustics.channel] model = \"rays\", or a .env of Bellhop")
      .Required();
  command.AddOption("--from", &options->from,
                    "Source: x,y,z in metres, East, North, down; default for a .env: its own");
  command.AddOption("--to", &options->to, "Receiver, likewise");
  command.AddOption("--set", &options->overrides, "Override a key of the mission file")
      .Repeatable();
  const Option plot = command.AddFlag(
      "--plot", &options->plot, "Draw impulse response, ray fan and transmission loss (gnuplot)");
  command.AddOption("--out", &options->out_dir, "Folder for the figures; default: rays")
      .Needs(plot);
  command.AddFlag("--png", &options->png, "PNG instead of SVG").Needs(plot);
  command.AddFlag("--keep", &options->keep, "Leave data and gnuplot scripts in OUT/gnuplot")
      .Needs(plot);
  command.Callback([options, action] {
    *action = [options] {
      const char* path = std::getenv("PATH");
      options->search_path = path == nullptr ? "" : path;
      return RunRays(*options, std::cout, std::cerr);
    };
  });
}

int RunShoalRays(int argc, char** argv) {
  return RunToolCommand("rays", argc, argv, AddRaysOptions);
}

}  // namespace shoal
