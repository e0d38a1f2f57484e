// `shoal import`: MOOS-IvP mission files to a mission of shoal.
#pragma once

#include <string>
#include <vector>

namespace shoal {

struct ImportOptions {
  std::vector<std::string> files;         ///< .moos and .bhv files, all of one mission.
  std::string out_path = {};              ///< Where the mission is written; empty: standard output.
  std::vector<std::string> defines = {};  ///< NAME=VALUE of macros.
  /// "NAME=VALUE NAME=\"a b\"": the vehicles' files are templates, read once with each of these.
  std::vector<std::string> vehicles = {};
  /// Folders of included files, besides the including file's own.
  std::vector<std::string> paths = {};
  /// The mission deploys its vehicles itself, and is run in the viewer once it is written.
  bool runs = false;
};

/// Writes the mission, and to stderr what needs care. Returns the exit code: 0 also where there
/// are warnings, kExitUsage where an option or a file cannot be read or `out_path` exists already,
/// kExitEnvironment where it cannot be written. With `runs` the process becomes `shoal run`.
int RunImport(const ImportOptions& options);

}  // namespace shoal
