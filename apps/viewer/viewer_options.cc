#include "apps/viewer/viewer_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "apps/viewer/outside_tiles.h"
#include "lib/base/check/result.h"
#include "lib/run/command_line/command.h"
#include "lib/run/run/app_options.h"

namespace shoal {

ViewerOptions ParseViewerOptionsOrExit(int argc, char** argv) {
  ViewerOptions options;
  bool interface = false;
  int http_port = -1;
  Program program(
      "shoal-viewer",
      "Shows a mission in the browser: a running one, or with --log a recorded one.\n"
      "`shoal run FILE --view` and `shoal view LOG` start it; without --log it shows the running\n"
      "mission, or waits for one.",
      "-v,--version");
  program.AddFlag("-i,--interface", &interface,
                  "Print the channels that it subscribes to and publishes, then exit");
  const Option port =
      program
          .AddOption("--port", &options.port_base,
                     "First LCM port of the mission (default: that of the one that runs)")
          .InRange(1024, 65535);
  program
      .AddOption("--http", &http_port,
                 fmt::format("TCP port of the page, 0: any (default: {}, or the first free one "
                             "after it)",
                             kFirstHttpPort))
      .InRange(0, 65535);
  program.AddOption(
      "--listen", &options.listen,
      "Address to be reached at, 0.0.0.0: all of this machine; beyond loopback the page "
      "needs the token that is printed (default: 127.0.0.1)");
  program.AddFlag("--allow-commands", &options.allow_commands,
                  "Allow commands to vehicles, broker and clock, and edited missions to be written "
                  "and run, with the token that is printed");
  program
      .AddOption(
          "--allow-tiles", &options.outside_tiles,
          "Let the page load tiles of a map from this address, https://HOST/{z}/{x}/{y}.png; "
          "without it, it loads nothing from outside")
      .Check([](const std::string& text) { return OutsideTilesProblem(text); });
  program.AddOption("--web", &options.web_folder, "Folder of the page, for those who work on it");
  const Option log =
      program.AddOption("--log", &options.log,
                        "Show this recorded mission: a log, or the folder of `shoal run --record`");
  log.Excludes(port).Check([](const std::string& text) {
    return text.empty() ? "it is empty: name a log, or the folder of a recording" : "";
  });
  program
      .AddOption("--plan", &options.plan,
                 "Show this mission file before it runs, to plan it on the map")
      .Excludes(port)
      .Excludes(log);
  program
      .AddOption("--mission", &options.mission_file,
                 "Mission file of the log (default: mission.toml beside it)")
      .Needs(log);
  const Option page = program.AddOption(
      "--export", &options.export_path,
      "Write the recorded mission as one file of HTML, to be opened without a viewer, and end");
  page.Needs(log).Check([](const std::string& text) {
    // Else a log that is named by mistake is lost.
    return text.ends_with(".html") ? "" : "a page ends in .html, such as berta.html";
  });
  program
      .AddOption("--export-step", &options.export_step_s,
                 "Seconds between the page's frames (default: at most 2000 frames)")
      .InRange(0.05, 600.0)
      .Needs(page);
  program.ParseOrExit(argc, argv);
  if (interface) {
    std::fputs(InterfaceText({.name = "viewer", .purpose = "", .example = ""}).c_str(), stdout);
    std::exit(kExitOk);
  }
  if (http_port >= 0) options.http_port = http_port;
  return options;
}

}  // namespace shoal
