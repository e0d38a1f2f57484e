// What a mission's launch script makes of its files, read as data: nothing is run.
//
//   LaunchPlan plan = ReadLaunchScript({"launch.sh", text}, find);
//   for (const LaunchFile& file : plan.files) ...  // meta_vehicle.moos, targ_abe.moos, VNAME=abe
//
// Knows of bash: variables, arrays, quotes, $((1 + 2)), ${X:0:3}, ${X#a}, if, for, while, until,
// case, [ ] and [[ ]], scripts that call others, echo and cat of files; nsplug, pAntler, uPokeDB,
// seq, expr, basename, dirname. Any other command is without effect; one that would give a value
// gives none and is named.
#pragma once

#include <string>
#include <vector>

#include "lib/tools/moos/import_buttons.h"
#include "lib/tools/moos/nsplug.h"

namespace shoal {

/// One file that is plugged, or that is used as it is.
struct LaunchFile {
  std::string source;   ///< "meta_vehicle.moos".
  std::string target;   ///< "targ_abe.moos"; the source's name where it is used as it is.
  MoosDefines defines;  ///< What nsplug is given.
};

struct LaunchPlan {
  std::vector<LaunchFile> files;
  std::vector<MoosButton> pokes;   ///< What each line of uPokeDB posts.
  std::vector<std::string> notes;  ///< "launch.sh:12: ...": what could not be read.
};

/// Reads a launch script as it is run without arguments. At most 50,000 commands and 8 scripts
/// within one another.
[[nodiscard]] LaunchPlan ReadLaunchScript(const MoosSource& script, const FindMoosFile& find);

}  // namespace shoal
