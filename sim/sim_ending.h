// What `shoal sim` and shoal-mpi print at the end of a mission.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/run/run/director.h"

namespace shoal {

struct SimEnding {
  const Mission& mission;
  const Director& director;
  int64_t step = -1;     ///< The last that was taken.
  double wall_s = 0;     ///< From the first step to the last.
  std::string where;     ///< "one process", "2 ranks".
  std::string log_path;  ///< Empty: no log.
  std::vector<std::string> losses;
  std::string fault;  ///< Why it could not go on; empty: it could.
  bool was_interrupted = false;
};

/// Prints how fast it was, where the log is, the mission's last page and what went wrong. Returns
/// the exit code.
int PrintEnding(const SimEnding& ending);

}  // namespace shoal
