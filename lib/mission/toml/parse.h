// TOML text to values. The only user of toml++, which is slow to compile.
#pragma once

#include <optional>
#include <string_view>

#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/value.h"

namespace shoal {

/// Returns the root table of `text`, every value with its place. A syntax error, a text that is
/// not UTF-8, one that is nested deeper than 32 levels (parts of dotted keys are levels too) or one
/// of more than 4 MiB is added to `problems`: only the first, since what follows it has no certain
/// meaning.
std::optional<Value> ParseToml(std::string_view text, Problems& problems);

/// Returns the value that `text` writes, placed at `place`, as in `key = text`; nullopt where it
/// is not exactly one TOML value.
std::optional<Value> ParseTomlValue(std::string_view text, const Place& place);

}  // namespace shoal
