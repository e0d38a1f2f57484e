#include "apps/shoal/group_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
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
    names.reserve(groups.size());
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

Option AddGrouping(Command command, std::string* grouping) {
  return command
      .AddOption("--grouping", grouping,
                 "Which participants share a process: app (none; the default of `shoal run`), "
                 "vehicle (those of a vehicle), host=N (N processes for all vehicles of a "
                 "computer), host (as many as there are processors)")
      .Check([](const std::string& text) {
        const Result<Grouping> parsed = ParseGrouping(text);
        return parsed.ok() ? "" : parsed.error();
      });
}

void AddGroup(Command shoal, CommandAction* action) {
  const Command command = shoal.AddSubcommand(
      "group", "Run several participants in one process; `shoal run --grouping` starts it");
  auto parsed = std::make_shared<GroupCommand>();
  AppOptions& options = parsed->options;
  command.AddOption("--mission", &options.mission_file, "Mission file").Required();
  command.AddOption("--set", &options.overrides, "Override a key of the mission file").Repeatable();
  AddGrouping(command, &parsed->grouping).Required();
  command.AddOption("--name", &parsed->name, "Which group: group-alpha, or group-1").Required();
  command
      .AddOption("--port", &options.port_base,
                 "First port of the mission (default: found by the mission file)")
      .InRange(1024, 65535);
  command
      .AddOption("--layout", &parsed->layout,
                 "shared or communities (default: as the running mission)")
      .OneOf({"shared", "communities"});
  command.AddOption("--mission-id", &options.mission_id,
                    "Reject messages of any other mission (default: that of the first tick)");
  command
      .AddOption("--lose", &options.lose,
                 "Fault injection: lose this share of incoming datagrams, to see them repaired")
      .InRange(0.0, 1.0);
  command.AddOption("--lose-forever", &options.lose_forever,
                    "Fault injection: lose every datagram of this channel");
  command.Callback([parsed, action] { *action = [parsed] { return RunGroup(*parsed); }; });
}

}  // namespace shoal
