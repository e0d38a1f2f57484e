// `shoal log encounters`: the encounters of a log's vessels, and how well each kept to the rules.
#pragma once

#include <iosfwd>
#include <string>

#include "lib/helm/encounters/encounter.h"

namespace shoal {

struct LogEncountersOptions {
  std::string path;
  EncounterOptions encounter = {};
  bool csv = false;          ///< Every number of every encounter, as CSV.
  bool explain = false;      ///< Every number in words.
  bool all = false;          ///< Every encounter, however many there are.
  bool skip_damage = false;  ///< Read what can be read of a damaged log.
};

/// Prints one line for each encounter and vessel, from NAV_<V>; names and lengths from
/// NODE_REPORT_LOCAL, the helms' own judgement from HELM_DECISION_<V>, where the log has them.
/// Returns the exit code: 0, kExitUsage for a log without NAV or options that do not fit together,
/// kExitEnvironment for one that cannot be read to its end.
int LogEncounters(const LogEncountersOptions& options, std::ostream& out, std::ostream& err);

}  // namespace shoal
