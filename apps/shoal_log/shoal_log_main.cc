// shoal-log, which `shoal log` becomes: reads logs.
#include "apps/shoal_log/log_options.h"
#include "lib/run/command_line/tool_commands.h"

int main(int argc, char** argv) {
  if (const auto code = shoal::StartToolCommand(argc, argv, "log")) return *code;
  return shoal::RunToolCommand("log", argc, argv, shoal::AddLogCommands);
}
