// shoal-import, which `shoal import` becomes: a mission of MOOS-IvP mission files.
#include "apps/shoal_import/import_options.h"
#include "lib/run/command_line/tool_commands.h"

int main(int argc, char** argv) {
  return shoal::RunToolCommand("import", argc, argv, shoal::AddImportOptions);
}
