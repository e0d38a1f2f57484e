// `shoal status` and `shoal url`: the status pages and the LCM URLs of a running mission.
#pragma once

#include <map>
#include <string>

#include "lib/base/check/result.h"
#include "lib/bus/bus/layout.h"
#include "shoal/appcast_t.hpp"

namespace shoal {

/// Asks a participant ("all": every one) for its page and collects what comes, by name; none where
/// no participant answers within two seconds. The error: the bus does not work.
[[nodiscard]] Result<std::map<std::string, appcast_t>> CollectPages(const PortPlan& ports,
                                                                    const std::string& app);

struct StatusOptions {
  int port_base = 0;  ///< 0: see ChooseMission.
  std::string app;    ///< A participant's name; "all": every page; empty: one line each.
};

/// Prints status pages. Returns the exit code.
int RunStatus(const StatusOptions& options);

/// Returns the LCM URL of a running mission's shore, or of a vehicle's community. The error of a
/// vehicle that it does not have begins with "no vehicle".
[[nodiscard]] Result<std::string> UrlOf(int port_base, const std::string& vehicle);

/// Prints the LCM URL of the shore, or of a vehicle's community. Returns the exit code.
int RunUrl(int port_base, const std::string& vehicle);

}  // namespace shoal
