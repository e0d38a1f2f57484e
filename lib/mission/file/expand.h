// Templates and fleets: expands the short forms of a mission file to one table per vehicle.
#pragma once

#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/value.h"

namespace shoal {

/// Lays each template of the tree over the one that it names by its own key `template`, in the same
/// way, as often as those name another; no template has that key afterwards. Refuses templates that
/// do not exist, and those that inherit from themselves. Called before ExpandVehicles.
void ExpandTemplates(Value& root, Problems& problems);

/// Replaces [[vehicle]] in the tree of a mission file by all vehicles in full: those of
/// [[vehicle]] in the order of the file, then those of each [[fleet]], each laid over its
/// template. Tables are merged key by key, anything else (also an array of tables, such as the
/// tasks) replaces what the template has. The tables [template] and [[fleet]] stay, for their own
/// check.
void ExpandVehicles(Value& root, Problems& problems);

}  // namespace shoal
