// `shoal log comms`: what a log shows of deliveries between vehicles: which vehicle received
// which, with what delay, and the age of what each vehicle knows.
#pragma once

#include <iosfwd>
#include <string>

namespace shoal {

struct LogCommsOptions {
  std::string path;
  std::string csv_dir = {};  ///< Also write tables into this folder; empty: none.
  bool all = false;          ///< Show every link and every contact, however many there are.
  bool skip_damage = false;  ///< Read what can be read of a damaged log.
};

/// Prints tables of links (COMMS_FATES), of swarm messages at their receivers and of the age of
/// information (SWARM_<V>); what the log does not hold is left out. Returns the exit code: 0,
/// kExitUsage for a log that holds none of it, kExitEnvironment for one that cannot be read to its
/// end, or a folder that cannot be written.
int LogComms(const LogCommsOptions& options, std::ostream& out, std::ostream& err);

}  // namespace shoal
