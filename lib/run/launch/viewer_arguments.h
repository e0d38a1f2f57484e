// The command line of shoal-viewer: for `shoal view`, and for `shoal run --view`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace shoal {

struct ViewOptions {
  /// A log, the folder of a recording, or a mission file (.toml) that does not run yet; empty: a
  /// running mission.
  std::string log = {};
  std::string mission_file = {};      ///< Of the log; empty: the one beside it.
  int port_base = 0;                  ///< Of the running mission; 0: the one that runs.
  std::optional<int> http_port = {};  ///< 0: any free one; absent: the viewer's default.
  std::string listen = {};            ///< Empty: loopback only.
  bool allow_commands = false;
  std::string outside_tiles = {};  ///< Where the page may load tiles from; empty: nowhere.
  std::string export_path = {};    ///< Of the page to write of `log`; empty: serve it.
  std::string export_step = {};    ///< Seconds between its frames; empty: chosen by the length.
};

/// Returns shoal-viewer's arguments.
std::vector<std::string> ViewerArguments(const ViewOptions& options);

}  // namespace shoal
