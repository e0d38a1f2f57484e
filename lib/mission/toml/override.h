// `--set key.path=value`: changes a mission from the command line before it is read.
//
// A path names tables by their keys, [[vehicle]], [[task]] and whatever else has a name by its
// name, which is that of its kind where a task or behavior has none, and other elements by their
// number from 1: comms.comms_range=300, vehicle.alpha.task.survey.speed_mps=2, event.1.at_s=90.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/value.h"

namespace shoal {

struct Override {
  std::vector<std::string> path;  ///< At least one part.
  Value value;
  Place place;
};

/// Parses "key.path=value"; `number` counts the overrides from 1. The value is TOML, or a bare
/// word, which stands for a string.
std::optional<Override> ParseOverride(std::string_view text, int64_t number, Problems& problems);

/// Returns the name of an element of [[parent]], or nullptr. That of a task or behavior is its kind
/// where the file gives it none.
const std::string* NameOfElement(const Value& element, std::string_view parent);

/// Sets the value in the tree of a mission file; tables that are missing on the way are made.
void Apply(const Override& override_, Value& root, Problems& problems);

}  // namespace shoal
