// The subcommands of shoal that look at what was recorded or written elsewhere: log, import, plot,
// rebroker.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace shoal {

/// Adds them; the one that is chosen puts what it does into `action`.
void AddLogCommands(CLI::App& cli, std::function<int()>* action);

}  // namespace shoal
