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

#include "lib/tools/moos/launch_plan.h"
#include "lib/tools/moos/nsplug.h"

namespace shoal {

/// Reads a launch script as it is run without arguments. At most 50,000 commands and 8 scripts
/// within one another.
[[nodiscard]] LaunchPlan ReadLaunchScript(const MoosSource& script, const FindMoosFile& find);

}  // namespace shoal
