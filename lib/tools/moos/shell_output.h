// What a command of a shell script prints, as far as it is known without being run.
#pragma once

#include <string>

#include "lib/tools/moos/shell_run.h"
#include "lib/tools/moos/shell_text.h"

namespace shoal {

/// Returns what `words`, the first of which is the command, prints: seq, basename, dirname, echo,
/// expr, pickpos and cat are known. Any other prints nothing and is noted.
[[nodiscard]] std::string ShellOutput(const ShellWords& words, int line, ShellRun* run);

}  // namespace shoal
