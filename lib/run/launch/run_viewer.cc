#include "lib/run/launch/run_viewer.h"

#include <fmt/format.h>

#include <cstdio>

#include "lib/base/check/result.h"
#include "lib/run/command_line/find_program.h"
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

}  // namespace shoal
