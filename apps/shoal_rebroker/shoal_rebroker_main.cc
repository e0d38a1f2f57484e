// shoal-rebroker, which `shoal rebroker` becomes: recorded reports by other rules.
#include "apps/shoal_rebroker/rebroker_options.h"
#include "lib/run/command_line/tool_commands.h"

int main(int argc, char** argv) {
  return shoal::RunToolCommand("rebroker", argc, argv, shoal::AddRebrokerOptions);
}
