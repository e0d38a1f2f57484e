#include "apps/shoal/group_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/run/run/app_options.h"
#include "lib/run/run/grouping.h"
#include "lib/run/run/run_app.h"
#include "sim/app_factory.h"

namespace shoal {

namespace {

struct GroupCommand {
  AppOptions options;
  std::string layout;
  std::string grouping;
  std::string name;
};

int RunGroup(GroupCommand command) {
  if (!command.layout.empty()) {
    command.options.layout = command.layout == "shared" ? Layout::kShared : Layout::kCommunities;
  }
  const std::optional<Mission> mission = LoadToTakePart(command.options);
  if (!mission) return kExitUsage;
  std::vector<RosterProcess> groups =
      ShareOut(MakeRoster(*mission, false), *ParseGrouping(command.grouping));
  std::erase_if(groups, [](const RosterProcess& process) { return !process.is_group(); });
  const auto group = std::find_if(groups.begin(), groups.end(), [&](const RosterProcess& process) {
    return process.name == command.name;
  });
  if (group == groups.end()) {
    std::vector<std::string> names;
    for (const RosterProcess& each : groups) names.push_back(each.name);
    fmt::print(stderr, "shoal: no group '{}' in {} with --grouping {}; it has: {}\n", command.name,
               command.options.mission_file, command.grouping,
               names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")));
    return kExitUsage;
  }
  std::vector<Joining> joining;
  for (const RosterEntry& entry : group->entries) {
    joining.push_back(
        {.name = entry.name, .make = [&](Bus& bus) { return MakeApp(entry, *mission, bus); }});
  }
  return RunJoined(command.options, group->name, *mission, joining);
}

}  // namespace

void AddGrouping(CLI::App* command, std::string* grouping) {
  command
      ->add_option("--grouping", *grouping,
                   "Which participants share a process: app (none; the default of `shoal run`), "
                   "vehicle (those of a vehicle), host=N (N processes for all vehicles of a "
                   "computer), host (as many as there are processors)")
      ->check([](const std::string& text) {
        const Result<Grouping> parsed = ParseGrouping(text);
        return parsed.ok() ? "" : parsed.error();
      });
}

void AddGroup(CLI::App& cli, std::function<int()>* action) {
  CLI::App* command = cli.add_subcommand(
      "group", "Run several participants in one process; `shoal run --grouping` starts it");
  auto parsed = std::make_shared<GroupCommand>();
  AppOptions& options = parsed->options;
  command->add_option("--mission", options.mission_file, "Mission file")->required();
  command->add_option("--set", options.overrides, "Override a key of the mission file")
      ->take_all()
      ->allow_extra_args(false);
  AddGrouping(command, &parsed->grouping);
  command->get_option("--grouping")->required();
  command->add_option("--name", parsed->name, "Which group: group-alpha, or group-1")->required();
  command
      ->add_option("--port", options.port_base,
                   "First port of the mission (default: found by the mission file)")
      ->check(CLI::Range(1024, 65535));
  command
      ->add_option("--layout", parsed->layout,
                   "shared or communities (default: as the running mission)")
      ->check(CLI::IsMember({"shared", "communities"}));
  command->add_option("--mission-id", options.mission_id,
                      "Reject messages of any other mission (default: that of the first tick)");
  command
      ->add_option("--lose", options.lose,
                   "Fault injection: lose this share of incoming datagrams, to see them repaired")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--lose-forever", options.lose_forever,
                      "Fault injection: lose every datagram of this channel");
  command->callback([parsed, action] { *action = [parsed] { return RunGroup(*parsed); }; });
}

}  // namespace shoal
