// The conditions of a shell script: [ ], [[ ]] and test.
#pragma once

#include "lib/tools/moos/shell_text.h"
#include "lib/tools/moos/shell_values.h"

namespace shoal {

/// Returns true where a test such as `[ "$X" = "a" -a -f b.moos ]` holds. Of other commands only
/// `true` does.
[[nodiscard]] bool HoldsInShell(const ShellCommand& command, ShellValues* values);

}  // namespace shoal
