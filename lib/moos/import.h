// MOOS-IvP mission files to a mission of shoal.
//
//   MoosImport import = ImportMoos({{{"shoreside.moos", text}, {"meta_abe.moos", other}}});
//   Write(import.mission); for (warning : import.warnings) Print(warning);
//
// A file with a block of pNodeReporter, uSimMarine, pHelmIvP or pMarinePID (or whose ANTLER runs
// one) is a vehicle's, named by its Community; any other is the shore's. All become one mission.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace shoal {

struct MoosSource {
  std::string name;  ///< Stands before line numbers, in comments and warnings.
  std::string text;
};

struct MoosImport {
  /// A mission file that LoadMissionText accepts. Every line of the sources is a setting (which
  /// names the line) or a comment that states why it is none.
  std::string mission;
  /// "a.moos:12: ..." where a line makes no sense, where shoal refuses a value, where something was
  /// missing that had to be made up, and where the mission changes: behaviors are not read, a
  /// vehicle becomes another, an event of a script is lost. Other lines without a counterpart are
  /// comments only.
  std::vector<std::string> warnings;
  size_t num_vehicles = 0;  ///< Described by the sources; the mission has at least one.
};

/// Converts any text; what cannot be converted becomes a comment.
[[nodiscard]] MoosImport ImportMoos(std::span<const MoosSource> sources);

}  // namespace shoal
