#include "lib/run/launch/viewer_arguments.h"

namespace shoal {

std::vector<std::string> ViewerArguments(const ViewOptions& options) {
  std::vector<std::string> arguments;
  const auto add = [&](const char* option, const std::string& value) {
    arguments.emplace_back(option);
    arguments.push_back(value);
  };
  if (!options.log.empty()) add(options.log.ends_with(".toml") ? "--plan" : "--log", options.log);
  if (!options.mission_file.empty()) add("--mission", options.mission_file);
  if (options.port_base != 0) add("--port", std::to_string(options.port_base));
  if (options.http_port) add("--http", std::to_string(*options.http_port));
  if (!options.listen.empty()) add("--listen", options.listen);
  if (options.allow_commands) arguments.emplace_back("--allow-commands");
  if (!options.outside_tiles.empty()) add("--allow-tiles", options.outside_tiles);
  if (!options.export_path.empty()) add("--export", options.export_path);
  if (!options.export_step.empty()) add("--export-step", options.export_step);
  return arguments;
}

}  // namespace shoal
