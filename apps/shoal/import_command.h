// `shoal import`: MOOS-IvP mission files to a mission of shoal; and the .alog lines of
// `shoal log csv --moos`.
#pragma once

#include <string>
#include <vector>

#include "lib/bus/record/log_commands.h"

namespace shoal {

struct ImportOptions {
  std::vector<std::string> files;         ///< .moos and .bhv files, all of one mission.
  std::string out_path = {};              ///< Where the mission is written; empty: standard output.
  std::vector<std::string> defines = {};  ///< NAME=VALUE of macros.
  /// "NAME=VALUE NAME=\"a b\"": the vehicles' files are templates, read once with each of these.
  std::vector<std::string> vehicles = {};
  /// Folders of included files, besides the including file's own.
  std::vector<std::string> paths = {};
};

/// Writes the mission, and to stderr what needs care. Returns the exit code: 0 also where there
/// are warnings, kExitUsage where an option or a file cannot be read or `out_path` exists already,
/// kExitEnvironment where it cannot be written.
int RunImport(const ImportOptions& options);

/// Node reports as MOOS text, in files that alog tools read (lib/tools/moos/alog.h).
LogLines NodeReportsAsAlog();

}  // namespace shoal
