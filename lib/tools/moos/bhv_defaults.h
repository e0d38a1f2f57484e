// What a behavior of MOOS-IvP has where its block does not state it, and shoal's has otherwise.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/bhv_file.h"
#include "lib/tools/moos/bhv_settings.h"

namespace shoal {

/// Sets keys that have another default there, and moves distances that cross. `has_duration`: the
/// block states that it has no limit of time.
void SetBhvDefaults(const BhvBlock& block, std::string_view kind, bool has_duration,
                    BhvSettings* settings, std::vector<std::string>* warnings);

}  // namespace shoal
