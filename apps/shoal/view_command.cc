#include "apps/shoal/view_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "lib/base/check/result.h"
#include "lib/run/launch/launch_plan.h"

namespace shoal {

int RunView(const ViewOptions& options) {
  const Result<std::string> viewer = FindProgram("shoal-viewer", "");
  if (!viewer.ok()) {
    fmt::print(stderr, "shoal: {}\n", viewer.error());
    return kExitEnvironment;
  }
  std::vector<std::string> words = ViewerArguments(options);
  words.insert(words.begin(), *viewer);
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::fflush(stdout);
  execv(argv[0], argv.data());
  fmt::print(stderr, "shoal: cannot run {}: {}\n", *viewer, std::strerror(errno));
  return kExitEnvironment;
}

}  // namespace shoal
