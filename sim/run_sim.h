// `shoal sim`: a mission in one process, as fast as possible, with a line of progress and a
// summary.
#pragma once

#include <string>
#include <vector>

#include "lib/bus/record/channel_choice.h"

namespace shoal {

struct SimOptions {
  std::string mission_file;
  std::vector<std::string> overrides;
  std::string log_path;  ///< Empty: no log.
  ChannelChoice log_channels = {};
  bool quiet = false;  ///< No progress line.
};

/// Returns the exit code.
int RunSim(const SimOptions& options);

}  // namespace shoal
