#include "lib/run/launch/run_viewer.h"

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <string>

#include "lib/base/check/result.h"
#include "lib/run/command_line/find_program.h"
#include "lib/run/command_line/own_files.h"
#include "lib/run/command_line/tool_commands.h"

namespace shoal {

int RunView(const ViewOptions& options) {
  const Result<std::string> viewer = FindProgram("shoal-viewer", "");
  if (!viewer.ok()) {
    fmt::print(stderr, "shoal: {}\n", viewer.error());
    return kExitEnvironment;
  }
  return BecomeProgram(*viewer, ViewerArguments(options));
}

int RunViewOfExample(ViewOptions options) {
  const std::optional<std::string> log = FindOwnFile("examples/recorded", ExecutableDirectory());
  if (!log) {
    fmt::print(stderr,
               "shoal: the recorded mission is not on this machine: it comes with the package "
               "(share/shoal/examples/recorded) and with the sources (examples/recorded)\n");
    return kExitEnvironment;
  }
  options.log = *log;
  return RunView(options);
}

}  // namespace shoal
