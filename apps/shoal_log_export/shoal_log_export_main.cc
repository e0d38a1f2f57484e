// shoal-log-export, which `shoal log mcap` and `shoal log sqlite` become.
#include "apps/shoal_log_export/log_export_options.h"
#include "lib/run/command_line/tool_commands.h"

int main(int argc, char** argv) {
  return shoal::RunToolCommand("log", argc, argv, shoal::AddLogExportCommands);
}
