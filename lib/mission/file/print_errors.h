// What a program prints of a mission file that it has loaded.
#pragma once

#include "lib/mission/file/load.h"

namespace shoal {

/// Prints to stderr all that is wrong with a mission file. Returns true where nothing is.
[[nodiscard]] bool LoadedWithoutErrors(const LoadedMission& loaded);

}  // namespace shoal
