// shoal-log, which `shoal log` becomes: reads logs, and writes them in other forms.
#include "apps/shoal_log/log_options.h"
#include "lib/run/command_line/tool_commands.h"

int main(int argc, char** argv) {
  return shoal::RunToolCommand("log", argc, argv, shoal::AddLogCommands);
}
