// `shoal status` and `shoal url`: asks a running mission what it does and where.
#pragma once

#include <string>

namespace shoal {

struct StatusOptions {
  int port_base = 0;  ///< 0: the one mission that runs.
  std::string app;    ///< A participant's name; "all": every page; empty: one line each.
};

/// Prints status pages. Returns the exit code.
int RunStatus(const StatusOptions& options);

/// Prints the LCM URL of the shore, or of a vehicle's community. Returns the exit code.
int RunUrl(int port_base, const std::string& vehicle);

}  // namespace shoal
