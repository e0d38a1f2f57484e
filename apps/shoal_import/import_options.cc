#include "apps/shoal_import/import_options.h"

#include <memory>

#include "apps/shoal_import/import_command.h"
#include "lib/run/command_line/tool_commands.h"

namespace shoal {

void AddImportOptions(Command command, CommandAction* action) {
  auto options = std::make_shared<ImportOptions>();
  command
      .AddOption("FILE", &options->files,
                 "A mission's folder, whose launch script is read, not run; or all files of one "
                 "mission: .moos "
                 "of shore and vehicles, .bhv of vehicles")
      .Required();
  command.AddOption("--out", &options->out_path,
                    "Mission file to write, one that is not there yet; default: standard output");
  command
      .AddOption("--define", &options->defines,
                 "NAME=VALUE of a macro, as for nsplug, or NAME; may be repeated")
      .Repeatable();
  command
      .AddOption("--vehicle", &options->vehicles,
                 "\"VNAME=abe START_POS=0,0\": the vehicles' files are templates, read once for "
                 "each of these")
      .Repeatable();
  command
      .AddOption("--path", &options->paths,
                 "Folders of files that others #include, with : between; may be repeated")
      .Repeatable();
  command.AddFlag(
      "--run", &options->runs,
      "Run it in the viewer, with its vehicles deployed; without --out it is written to "
      "FOLDER.toml");
  command.Callback([options, action] { *action = [options] { return RunImport(*options); }; });
}

int RunShoalImport(int argc, char** argv) {
  return RunToolCommand("import", argc, argv, AddImportOptions);
}

}  // namespace shoal
