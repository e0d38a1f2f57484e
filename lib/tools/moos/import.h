// MOOS-IvP mission files to a mission of shoal.
//
//   MoosImport import = ImportMoos({{{"shoreside.moos", text}, {"meta_abe.moos", other},
//                                    {"meta_abe.bhv", behaviors}}}, {});
//   Write(import.mission); for (warning : import.warnings) Print(warning);
//
// A file with a block of pNodeReporter, uSimMarine, pHelmIvP or pMarinePID (or whose ANTLER runs
// one) is a vehicle's, named by its Community; any other is the shore's. All become one mission.
// A file whose name ends with .bhv holds behaviors. A vehicle's is the one that its pHelmIvP names,
// or that is named as its .moos file; else the only one that is given.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/import_buttons.h"
#include "lib/tools/moos/import_outlook.h"
#include "lib/tools/moos/nsplug.h"

namespace shoal {

/// A file that a launch script has plugged, with what nsplug was given.
struct MoosRun {
  MoosSource source;
  std::string target;  ///< "targ_abe.bhv".
  MoosDefines defines;
  PlugOptions options = {};
};

struct MoosImportOptions {
  MoosDefines defines = {};  ///< Values of macros, in every file.
  /// Not empty: a vehicle's file is a template, imported once for each of these, with these values
  /// besides.
  std::vector<MoosDefines> vehicles = {};
  /// Files besides the sources, each as it was plugged for one vehicle or the shore.
  std::vector<MoosRun> runs = {};
  bool deploys = false;                ///< Adds an [[event]] that deploys all vehicles at once.
  std::vector<MoosButton> pokes = {};  ///< What a launch script posts by uPokeDB.
  /// Finds included files, and behavior files that are not among the sources; may be empty.
  FindMoosFile find = {};
};

struct MoosImport {
  /// A mission file that LoadMissionText accepts, unless it is too long for it (a warning). Every
  /// line of the sources is a setting (which names the line) or a comment that states why it is
  /// none.
  std::string mission;
  /// "a.moos:12: ..." where a line makes no sense, where shoal refuses a value, where something was
  /// missing that had to be made up, and where the mission changes: a behavior or a key of one is
  /// lost, a vehicle becomes another, an event of a script is lost. Other lines without a
  /// counterpart are comments only.
  std::vector<std::string> warnings;
  /// "a.bhv:12: Behavior = BHV_X: ...": what is lost, one line for each behavior, app and button.
  std::vector<std::string> lost;
  std::vector<VehicleOutlook> outlooks;  ///< What each vehicle does after `deploy`.
  size_t num_vehicles = 0;  ///< Described by the sources; the mission has at least one.
};

/// Converts any text; what cannot be converted becomes a comment.
[[nodiscard]] MoosImport ImportMoos(std::span<const MoosSource> sources,
                                    const MoosImportOptions& options = {});

/// Returns true for the name of a file of behaviors.
[[nodiscard]] bool IsBhvName(std::string_view name);

}  // namespace shoal
