#include "apps/shoal_log_export/log_export_options.h"

#include <iostream>
#include <memory>

#include "lib/base/check/result.h"
#include "lib/bus/record/log_commands.h"
#include "lib/run/command_line/tool_commands.h"
#include "lib/run/run/log_arguments.h"
#include "lib/tools/mcap/log_mcap.h"
#include "lib/tools/sqlite/log_sqlite.h"

namespace shoal {

namespace {

void AddLogMcap(Command log, CommandAction* action) {
  const Command command = AddToolCommand(log, "log", "mcap");
  auto options = std::make_shared<LogMcapOptions>();
  command.AddOption("LOG", &options->path, kLogArgument).Required();
  command.AddOption("--out", &options->out_path, "The file").Required();
  AddLogSelection(command, &options->selection);
  command.AddFlag("--skip-damage", &options->skip_damage, "Convert what can be read of a bad log");
  command.AddFlag("--only-log", &options->only_log,
                  "Leave out the poses, places and lines of text that are made of the log");
  AddLogTypes(command, &options->types);
  command.Callback([options, action] {
    *action = [options] {
      if (!IsSelectionSound(options->selection, std::cerr)) return static_cast<int>(kExitUsage);
      return LogMcap(*options, std::cout, std::cerr);
    };
  });
}

void AddLogSqlite(Command log, CommandAction* action) {
  const Command command = AddToolCommand(log, "log", "sqlite");
  auto options = std::make_shared<LogSqliteOptions>();
  command.AddOption("LOG", &options->path, kLogArgument).Required();
  command.AddOption("--out", &options->out_path, "The file").Required();
  AddLogSelection(command, &options->selection);
  command.AddFlag("--skip-damage", &options->skip_damage, "Convert what can be read of a bad log");
  AddLogTypes(command, &options->types);
  command.Callback([options, action] {
    *action = [options] {
      if (!IsSelectionSound(options->selection, std::cerr)) return static_cast<int>(kExitUsage);
      return LogSqlite(*options, std::cout, std::cerr);
    };
  });
}

}  // namespace

void AddLogExportCommands(Command log, CommandAction* action) {
  AddLogMcap(log, action);
  AddLogSqlite(log, action);
}

int RunShoalLogExport(int argc, char** argv) {
  return RunToolCommand("log", argc, argv, AddLogExportCommands);
}

}  // namespace shoal
