// The command line of shoal-viewer.
#pragma once

#include <optional>
#include <string>

namespace shoal {

struct ViewerOptions {
  int port_base = 0;             ///< First LCM port of the mission; 0: the one that runs.
  std::optional<int> http_port;  ///< Absent: the first free one from kFirstHttpPort on.
  std::string listen = "127.0.0.1";
  bool allow_commands = false;
  std::string plan;           ///< A mission file that is shown before it runs; empty: none.
  std::string outside_tiles;  ///< OutsideTilesProblem() is empty; empty: none.
  std::string web_folder;     ///< Empty: the page as it was built in.
  std::string log;          ///< A recorded mission: its log, or the folder of `shoal run --record`.
  std::string export_path;  ///< Of the page to write of `log`; empty: serve it.
  double export_step_s = 0;  ///< Between its frames; 0: chosen by the length.
  std::string mission_file;  ///< Of the log, where it is not beside it.
};

inline constexpr int kFirstHttpPort = 8765;
inline constexpr int kMoreHttpPorts = 50;

/// Parses the command line; handles --help, --version and --interface; exits with 0 or kExitUsage
/// where there is nothing more to do.
ViewerOptions ParseViewerOptionsOrExit(int argc, char** argv);

}  // namespace shoal
