// Whether vehicles start in the ground of the mission's own map, or are sent into it.
#pragma once

#include "lib/mission/file/validate.h"
#include "lib/sea/ocean/sea_floor.h"

namespace shoal {

/// Warns of starts at which the floor lies at the vehicle's keel or above it, and of ways of tasks
/// that lead there; of those that cannot but happen as of a sure failure. Not for what is moored or
/// replayed.
void ValidateGround(const Mission& mission, const SeaFloor& floor, const TablePlace& file);

}  // namespace shoal
