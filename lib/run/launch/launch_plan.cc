#include "lib/run/launch/launch_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "lib/base/text/letters.h"
#include "lib/run/command_line/find_program.h"
#include "lib/run/run/run_registry.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> ArgumentsOf(const RosterProcess& process, const LaunchContext& context) {
  const RosterEntry& entry = process.entries.front();
  if (!process.is_group() && !entry.command.empty()) {
    return {entry.command.begin() + 1, entry.command.end()};
  }
  std::vector<std::string> arguments = {"--mission", context.mission.file};
  if (process.is_group()) arguments.insert(arguments.begin(), "group");
  const auto add = [&](std::string option, std::string value) {
    arguments.push_back(std::move(option));
    arguments.push_back(std::move(value));
  };
  if (process.is_group()) {
    add("--grouping", Name(context.options.grouping));
    add("--name", process.name);
  } else if (!entry.vehicle.empty()) {
    add("--vehicle", entry.vehicle);
  }
  for (const std::string& each : context.options.overrides) add("--set", each);
  add("--port", std::to_string(context.ports.base()));
  add("--layout", std::string(Name(context.ports.layout())));
  add("--mission-id", std::to_string(context.mission_id));
  if (entry.app == "recorder") {
    add("--log", context.log_path);
    for (const std::string& each : context.options.log_channels.only) add("--channels", each);
    for (const std::string& each : context.options.log_channels.without) add("--without", each);
  }
  if (context.options.lose > 0) add("--lose", fmt::format("{}", context.options.lose));
  if (!context.options.lose_forever.empty()) add("--lose-forever", context.options.lose_forever);
  return arguments;
}

/// The program of a participant that has a process of its own.
Result<std::string> ProgramOf(const RosterEntry& entry, const Mission& mission) {
  Result<std::string> path =
      FindProgram(entry.command.empty() ? entry.app : entry.command.front(), mission.file);
  if (path.ok()) return path;
  std::string message = fmt::format("{}: {}", entry.name, path.error());
  if (!entry.command.empty()) {
    message += fmt::format(". Build it, or correct the command of [[participant]] {} in {}",
                           entry.name, mission.file);
  }
  return Error{message};
}

}  // namespace

std::vector<std::string> ParticipantEnvironment(const std::string& name,
                                                const LaunchContext& context) {
  std::string vehicles;
  for (const std::string& vehicle : VehicleNames(context.mission)) {
    vehicles += (vehicles.empty() ? "" : ",") + vehicle;
  }
  std::vector<std::string> variables = {
      fmt::format("SHOAL_PORT={}", context.ports.base()),
      fmt::format("SHOAL_LAYOUT={}", Name(context.ports.layout())),
      fmt::format("SHOAL_MISSION_ID={}", context.mission_id),
      fmt::format("SHOAL_PARTICIPANT={}", name),
      fmt::format("SHOAL_VEHICLES={}", vehicles),
      fmt::format("{}={}", kSecretFileVariable, SecretPath(context.ports.base()))};
  // The playback of a log may have none.
  if (const std::string& file = context.mission.file; !file.empty()) {
    variables.push_back(fmt::format("SHOAL_MISSION_FILE={}", fs::absolute(file).string()));
  }
  return variables;
}

std::vector<std::string> MissingPrograms(const Mission& mission,
                                         const std::vector<RosterProcess>& processes) {
  std::vector<std::string> missing;
  for (const RosterProcess& process : processes) {
    const RosterEntry& entry = process.entries.front();
    if (process.is_group() || entry.provider == Provider::kHand || !entry.host.empty()) continue;
    const Result<std::string> path = ProgramOf(entry, mission);
    if (!path.ok()) missing.push_back(path.error());
  }
  return missing;
}

Result<ChildCommand> CommandOf(const RosterProcess& process, const LaunchContext& context) {
  Result<std::string> path = process.is_group()
                                 ? FindProgram("shoal", context.mission.file)
                                 : ProgramOf(process.entries.front(), context.mission);
  if (!path.ok()) return Error{path.error()};
  ChildCommand command{.name = process.name,
                       .argv = {*path},
                       .environment = ParticipantEnvironment(process.name, context),
                       .log_path = fmt::format("{}/{}.txt", context.log_dir, process.name),
                       .inherited_fd = context.secret_fd};
  command.environment.push_back(fmt::format("{}={}", kSecretFdVariable, context.secret_fd));
  const std::vector<std::string> arguments = ArgumentsOf(process, context);
  command.argv.insert(command.argv.end(), arguments.begin(), arguments.end());
  return command;
}

Result<ChildCommand> ViewerCommand(const LaunchContext& context) {
  Result<std::string> viewer = FindProgram("shoal-viewer", context.mission.file);
  if (!viewer.ok()) return Error{viewer.error()};
  ViewOptions view = *context.options.view;
  view.port_base = context.ports.base();
  ChildCommand command{.name = "shoal-viewer",
                       .argv = ViewerArguments(view),
                       .environment = {},
                       .log_path = context.log_dir + "/shoal-viewer.txt",
                       // It prints the token that lets people command the vehicles.
                       .is_log_private = true};
  command.argv.insert(command.argv.begin(), *viewer);
  return command;
}

std::string ShellVariables(const std::vector<std::string>& variables) {
  std::string text;
  for (const std::string& each : variables) {
    const size_t at = each.find('=') + 1;
    const std::string value = each.substr(at);
    const bool is_plain = std::all_of(value.begin(), value.end(), [](char c) {
      return IsNameCharacter(c) || std::string_view("/.,:+-").find(c) != std::string_view::npos;
    });
    text += (text.empty() ? "" : " ") + each.substr(0, at);
    if (is_plain) {
      text += value;
      continue;
    }
    text += '\'';
    for (const char c : value) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += '\'';
  }
  return text;
}

std::string HandCommand(const RosterEntry& entry, const LaunchContext& context) {
  if (entry.app.empty()) {
    // To be pasted before the user's command.
    return ShellVariables(ParticipantEnvironment(entry.name, context)) + " ";
  }
  const std::string mission = fs::absolute(context.mission.file).lexically_normal().string();
  std::string command = fmt::format("{}/{} --mission {} --port {}", ExecutableDirectory(),
                                    entry.app, mission, context.ports.base());
  if (!entry.vehicle.empty()) command += " --vehicle " + entry.vehicle;
  for (const std::string& each : context.options.overrides) {
    command += fmt::format(" --set '{}'", each);
  }
  return command;
}

Result<std::vector<ChildCommand>> LcmLoggerCommands(const LaunchContext& context) {
  Result<std::string> logger = FindProgram("lcm-logger", context.mission.file);
  if (!logger.ok()) return Error{logger.error() + "; apt-get install liblcm-bin"};
  std::vector<ChildCommand> commands;
  for (const int port : context.ports.DataPorts()) {
    const std::string name = fmt::format("lcm-logger-{}", port);
    commands.push_back({.name = name,
                        .argv = {*logger, "--quiet", "--force", "--lcm-url=" + LcmUrl(port),
                                 fmt::format("{}/{}.lcm", context.options.record_dir, name)},
                        .environment = {},
                        .log_path = fmt::format("{}/{}.txt", context.log_dir, name)});
  }
  return commands;
}

}  // namespace shoal
