// What is known of a path before it is flown, for `shoal check` and --explain.
#pragma once

#include <string>

#include "lib/vehicle/guidance/task.h"

namespace shoal {

/// Returns the path's points, length, time by MuNet's estimate (a margin of 20 %), depths and area:
/// "5 points, 1204.2 m, about 723 s at 2 m/s, depths from 20 to 30 m, a square of 300 m".
[[nodiscard]] std::string PathText(const PathFollowTask& task);

}  // namespace shoal
