// Which table of a mission file has a key: for users who wrote it into another one.
#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// Returns the first table, in the order of `shoal check --explain`, that has `key`: "[acoustics]",
/// "[[vehicle]]". Nothing where none has it. Tables of behaviors, and of models but the default,
/// are not looked at.
[[nodiscard]] std::string HomeOfKey(std::string_view key);

}  // namespace shoal
