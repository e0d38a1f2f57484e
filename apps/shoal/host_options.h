// The command line of `shoal host`.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace shoal {

/// Adds `shoal host` and its subcommand; the chosen one sets `action`.
void AddHostCommands(CLI::App& cli, std::function<int()>* action);

}  // namespace shoal
