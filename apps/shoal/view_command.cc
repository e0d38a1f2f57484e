#include "apps/shoal/view_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "apps/shoal/launch_plan.h"
#include "lib/check/result.h"

namespace shoal {

std::vector<std::string> ViewerArguments(const ViewOptions& options) {
  std::vector<std::string> arguments;
  const auto add = [&](const char* option, const std::string& value) {
    arguments.emplace_back(option);
    arguments.push_back(value);
  };
  if (!options.log.empty()) add("--log", options.log);
  if (!options.mission_file.empty()) add("--mission", options.mission_file);
  if (options.port_base != 0) add("--port", std::to_string(options.port_base));
  if (options.http_port) add("--http", std::to_string(*options.http_port));
  if (!options.listen.empty()) add("--listen", options.listen);
  if (options.allow_commands) arguments.emplace_back("--allow-commands");
  return arguments;
}

int RunView(const ViewOptions& options) {
  const Result<std::string> viewer = FindProgram("shoal-viewer", "");
  if (!viewer.ok()) {
    fmt::print(stderr, "shoal: {}\n", viewer.error());
    return kExitEnvironment;
  }
  std::vector<std::string> words = ViewerArguments(options);
  words.insert(words.begin(), *viewer);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::fflush(stdout);
  execv(argv[0], argv.data());
  fmt::print(stderr, "shoal: cannot run {}: {}\n", *viewer, std::strerror(errno));
  return kExitEnvironment;
}

}  // namespace shoal
