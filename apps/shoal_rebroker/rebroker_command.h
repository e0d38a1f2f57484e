// `shoal rebroker`: what would have been delivered with other rules.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace shoal {

struct RebrokerOptions {
  std::vector<std::string> logs = {};  ///< More than one: of loggers of the same mission.
  std::string comms_file = {};         ///< Empty: the rules that the log holds.
  std::string out_path = {};           ///< Empty: no new log.
  bool no_controls = false;            ///< Leave out what was published on UNC_*.
  bool all_links = false;    ///< Show links without a difference too, however many there are.
  bool skip_damage = false;  ///< Read what can be read of a damaged log.
};

/// Returned where the recorded rules did not give the recorded decisions.
inline constexpr int kDecisionsDiffer = 1;

/// Writes the comparison to `out`, warnings and errors to `err`, and returns the exit code: 0,
/// kDecisionsDiffer, kExitUsage or kExitEnvironment.
int RunRebroker(const RebrokerOptions& options, std::ostream& out, std::ostream& err);

}  // namespace shoal
