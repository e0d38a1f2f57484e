// The command line of `shoal host`.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace shoal {

/// Adds `shoal host` and its subcommand; the chosen one sets `action`.
void AddHostCommands(CLI::App& cli, std::function<int()>* action);

}  // namespace shoal
