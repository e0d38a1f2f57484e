// What `shoal rebroker` prints about a log and about the decisions; the table is in link_table.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/run/broker/broker_setup.h"
#include "lib/tools/rebroker/comms_log.h"
#include "lib/tools/rebroker/rebroker.h"

namespace shoal {

/// Returns what the log holds, a line for each; `recorded` where it contains its rules.
[[nodiscard]] std::string LogText(const std::vector<std::string>& paths, const CommsLog& log,
                                  const std::optional<BrokerSetup>& recorded);

/// Returns what seems to be missing or odd.
[[nodiscard]] std::vector<std::string> WarningsOf(const CommsLog& log);

/// Returns "reproduced N of N decisions", and the first difference where there is one.
[[nodiscard]] std::string ReproducedText(const CommsLog& log, const RebrokerOutcome& outcome);

/// Returns a line for each rule and each vehicle's factors that differ, or one that states that
/// none do.
[[nodiscard]] std::string ChangesText(const BrokerSetup& then, const BrokerSetup& now);

/// Returns the times in which the recorded broker was away, and what came too early.
[[nodiscard]] std::string AbsencesText(const CommsLog& log, const RebrokerOutcome& outcome);

}  // namespace shoal
