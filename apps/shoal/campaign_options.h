// The subcommands of `shoal campaign`.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace shoal {

/// Adds them; the chosen one sets `action` to what it runs.
void AddCampaignCommands(CLI::App& cli, std::function<int()>* action);

}  // namespace shoal
