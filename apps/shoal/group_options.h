// `shoal group`: the process in which several participants of a mission run
// (lib/run/run/grouping.h). `shoal run --grouping` starts it.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace shoal {

/// Adds the option --grouping, with a text that ParseGrouping reads.
void AddGrouping(CLI::App* command, std::string* grouping);

/// Adds the command; where it is chosen, it sets `action` to what it runs.
void AddGroup(CLI::App& cli, std::function<int()>* action);

}  // namespace shoal
