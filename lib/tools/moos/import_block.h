// One block of a behavior file as a [[vehicle.behavior]].
#pragma once

#include "lib/tools/moos/bhv_file.h"
#include "lib/tools/moos/import_behaviors.h"

namespace shoal {

/// Adds the behavior of a block, or comments where shoal has no kind for it.
void ImportBhvBlock(const BhvBlock& block, BhvImport* import);

}  // namespace shoal
