// Values as TOML writes them in one line.
#pragma once

#include <string>

#include "lib/mission/toml/value.h"

namespace shoal {

/// Returns the value as `--set key=` takes it: "250", "\"nolimit\"", "[1, 2]", "{x_m = 1}".
[[nodiscard]] std::string TomlText(const Value& value);

}  // namespace shoal
