// `shoal log mcap`: a log as an MCAP file, for Foxglove, Rerun and PlotJuggler.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "lib/bus/record/log_commands.h"

namespace shoal {

struct LogMcapOptions {
  std::string path = {};
  std::string out_path = {};  ///< A file or link of this name is replaced.
  LogSelection selection = {};
  bool skip_damage = false;
  bool only_log = false;  ///< Without the messages of lib/tools/mcap/shown_messages.h.
  std::vector<std::string> types = {};
};

/// Writes the selected messages as protobuf (lib/tools/mcap/proto_schema.h has the types), one MCAP
/// channel for each channel of the log and type on it, with the events' times. A log that is
/// damaged or cut gives a whole file of what can be read before, and kExitEnvironment.
int LogMcap(const LogMcapOptions& options, std::ostream& out, std::ostream& err);

}  // namespace shoal
