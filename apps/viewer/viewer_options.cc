#include "apps/viewer/viewer_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "lib/base/check/result.h"
#include "lib/run/command_line/version_text.h"
#include "lib/run/run/app_options.h"

namespace shoal {

ViewerOptions ParseViewerOptionsOrExit(int argc, char** argv) {
  ViewerOptions options;
  bool interface = false;
  int http_port = -1;
  CLI::App cli(
      "Shows a mission in the browser: a running one, or with --log a recorded one.\n"
      "`shoal run FILE --view` and `shoal view LOG` start it; without --log it shows the running\n"
      "mission, or waits for one.",
      "shoal-viewer");
  cli.set_version_flag("-v,--version", VersionText("shoal-viewer"));
  cli.add_flag("-i,--interface", interface,
               "Print the channels that it subscribes to and publishes, then exit");
  CLI::Option* port =
      cli.add_option("--port", options.port_base,
                     "First LCM port of the mission (default: that of the one that runs)")
          ->check(CLI::Range(1024, 65535));
  cli.add_option("--http", http_port,
                 fmt::format("TCP port of the page, 0: any (default: {}, or the first free one "
                             "after it)",
                             kFirstHttpPort))
      ->check(CLI::Range(0, 65535));
  cli.add_option("--listen", options.listen,
                 "Address to be reached at, 0.0.0.0: all of this machine; beyond loopback the page "
                 "needs the token that is printed (default: 127.0.0.1)");
  CLI::Option* commands =
      cli.add_flag("--allow-commands", options.allow_commands,
                   "Allow commands to vehicles, broker and clock, with the token that is printed");
  cli.add_option("--web", options.web_folder, "Folder of the page, for those who work on it");
  CLI::Option* log =
      cli.add_option("--log", options.log,
                     "Show this recorded mission: a log, or the folder of `shoal run --record`");
  log->excludes(port)->excludes(commands)->check([](const std::string& text) {
    return text.empty() ? "it is empty: name a log, or the folder of a recording" : "";
  });
  cli.add_option("--mission", options.mission_file,
                 "Mission file of the log (default: mission.toml beside it)")
      ->needs(log);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = cli.exit(error);
    std::exit(code == 0 ? kExitOk : kExitUsage);
  }
  if (interface) {
    std::fputs(InterfaceText({.name = "viewer", .purpose = "", .example = ""}).c_str(), stdout);
    std::exit(kExitOk);
  }
  if (http_port >= 0) options.http_port = http_port;
  return options;
}

}  // namespace shoal
