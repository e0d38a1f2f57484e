#include "apps/shoal_import/import_options.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "apps/shoal_import/import_command.h"

namespace shoal {

void AddImportOptions(CLI::App* command, CommandAction* action) {
  auto options = std::make_shared<ImportOptions>();
  command
      ->add_option("FILE", options->files,
                   "All files of one mission: .moos of shore and vehicles, .bhv of vehicles")
      ->required();
  command->add_option("--out", options->out_path,
                      "Mission file to write, one that is not there yet; default: standard output");
  command
      ->add_option("--define", options->defines,
                   "NAME=VALUE of a macro, as for nsplug; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  command
      ->add_option("--vehicle", options->vehicles,
                   "\"VNAME=abe START_POS=0,0\": the vehicles' files are templates, read once for "
                   "each of these")
      ->take_all()
      ->allow_extra_args(false);
  command
      ->add_option("--path", options->paths,
                   "Folder of files that others #include; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  command->callback([options, action] { *action = [options] { return RunImport(*options); }; });
}

}  // namespace shoal
