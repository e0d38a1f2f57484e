// `shoal send`: speaks to a running mission from a shell.
#pragma once

#include <string>
#include <vector>

namespace shoal {

struct SendOptions {
  int port_base = 0;               ///< 0: the one mission that runs.
  std::string target;              ///< A vehicle, "all", or a rule such as comms_range.
  std::vector<std::string> words;  ///< Command and arguments, or the rule's vehicle and value.
};

/// Returns the exit code: kExitUsage also where a helm refused. Prints what was sent, and what came
/// of it where that can be seen.
int RunSend(const SendOptions& options);

}  // namespace shoal
