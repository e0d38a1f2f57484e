// `shoal log helm`: why a helm steered as it did, from the HELM_DECISION messages of a log, and
// which waypoints it reached, from HELM_STATE.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

namespace shoal {

struct LogHelmOptions {
  std::string path;
  std::string vehicle = {};         ///< Empty: all; needed with at_s where a log has several.
  std::optional<double> at_s = {};  ///< The decision that counted at this time, in full.
  bool only_changes = false;  ///< Leaves out decisions that hardly differ from the line before.
  bool skip_damage = false;   ///< Read what can be read of a damaged log.
};

/// Prints one line for each decision and waypoint reached, or with at_s the decision that counted
/// then in full. Returns the exit code: 0, kExitUsage where the log holds nothing that was asked
/// for, kExitEnvironment for a log that cannot be read to its end.
int LogHelm(const LogHelmOptions& options, std::ostream& out, std::ostream& err);

}  // namespace shoal
