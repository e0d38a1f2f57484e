// shoal-plot, which `shoal plot` becomes: figures of a log.
#include "apps/shoal_plot/plot_options.h"
#include "lib/run/command_line/tool_commands.h"

int main(int argc, char** argv) {
  return shoal::RunToolCommand("plot", argc, argv, shoal::AddPlotOptions);
}
