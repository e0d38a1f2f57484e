// The subcommands of shoal that look at what was recorded or written elsewhere: log, import, plot,
// rebroker.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace shoal {

/// Adds them; the chosen one sets `action` to what it runs.
void AddLogCommands(CLI::App& cli, std::function<int()>* action);

}  // namespace shoal
