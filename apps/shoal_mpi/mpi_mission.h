// A mission by all ranks of an MPI job: the same log, verdict and summary as of `shoal sim`.
#pragma once

#include <string>
#include <vector>

#include "lib/bus/record/channel_choice.h"

namespace shoal {

struct MpiOptions {
  std::string mission_file;
  std::vector<std::string> overrides = {};
  std::string log_path = {};  ///< Of rank 0; empty: no log.
  ChannelChoice log_channels = {};
  std::vector<std::string> placed = {};  ///< As MakePlacement takes them.
  double give_up_after_s = 60;           ///< Wall time until a rank that does not answer is lost.
  bool shows_times = false;              ///< Prints where each rank's wall time went.
  bool quiet = false;                    ///< No line for each rank at the start.
};

/// Takes this process's part in the mission. Returns the exit code, the same for all ranks.
int RunMpiMission(const MpiOptions& options);

}  // namespace shoal
