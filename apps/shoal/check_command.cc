#include "apps/shoal/check_command.h"

#include <fmt/format.h>

#include <variant>

#include "apps/shoal/explain_network.h"
#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/os/read_file.h"
#include "lib/mission/file/key_paths.h"
#include "lib/mission/file/path_text.h"
#include "lib/mission/file/print_errors.h"
#include "lib/run/launch/launch_plan.h"
#include "lib/run/run/log_plan.h"
#include "lib/run/run/roster.h"

namespace shoal {

namespace {

/// Returns "1 vehicle", "2 vehicles".
std::string Counted(size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

int RunCheck(const std::string& mission_file, const std::vector<std::string>& overrides,
             bool explain) {
  const LoadedMission loaded = LoadMission(mission_file, overrides);
  if (!LoadedWithoutErrors(loaded)) {
    fmt::print(stderr, "{}\n", Counted(loaded.errors.size(), "error"));
    return kExitUsage;
  }
  if (loaded.num_sure_failures > 0) {
    fmt::print(stderr, "{}: it can be run, and fails for certain: {} of the warnings above\n",
               mission_file, loaded.num_sure_failures);
    return kExitUsage;
  }
  if (explain) {
    fmt::print("{}{}", Explain(loaded.mission), ExplainNetwork(loaded.mission));
    return kExitOk;
  }
  const Mission& mission = loaded.mission;
  std::vector<RosterEntry> roster = MakeRoster(mission, false);
  const size_t num_participants = roster.size() + 1;
  std::erase_if(roster, [](const RosterEntry& entry) { return entry.command.empty(); });
  const std::vector<std::string> missing = MissingPrograms(mission, ShareOut(roster, Grouping()));
  for (const std::string& each : missing) fmt::print(stderr, "{}\n", each);
  if (!missing.empty()) {
    fmt::print(stderr, "{}: valid, but `shoal run` cannot start it here: {} missing\n",
               mission_file, Counted(missing.size(), "program"));
    return kExitEnvironment;
  }
  fmt::print("{}: ok: {}, {}, {} s in {}, {}, {}\n", mission_file,
             Counted(mission.vehicles.size(), "vehicle"), Counted(num_participants, "participant"),
             mission.duration_s, Counted(static_cast<size_t>(mission.LastStep() + 1), "step"),
             Counted(mission.events.size(), "event"),
             Counted(mission.expectations.size(), "expectation"));
  const double log_bytes = EstimateLog_bytes(mission);
  fmt::print("log: about {}, {} compressed{}\n", BytesText(log_bytes),
             BytesText(log_bytes * kCompressedShare),
             log_bytes > kPlainLog_bytes ? ", as --record makes it" : "");
  for (const std::string& warning : PlanLog(mission, {}, ".").warnings) {
    fmt::print(stderr, "{}: warning: {}\n", mission_file, warning);
  }
  for (const Vehicle& vehicle : mission.vehicles) {
    for (const Task& task : vehicle.tasks) {
      const auto* path = std::get_if<PathFollowTask>(&task.what);
      if (path == nullptr) continue;
      fmt::print("{}, task {}: {}\n", vehicle.name, task.name, PathText(*path));
    }
  }
  return kExitOk;
}

int RunKeys(const std::string& mission_file, const std::vector<std::string>& overrides) {
  const LoadedMission loaded = LoadMission(mission_file, overrides);
  if (!LoadedWithoutErrors(loaded)) return kExitUsage;
  for (const std::string& path : KeyPaths(loaded.mission, ReadRegularFile(mission_file).text)) {
    fmt::print("{}\n", path);
  }
  return kExitOk;
}

std::string ChannelsMarkdown() {
  std::string text =
      "# Channels\n\n"
      "Made by `shoal channels` from `lib/bus/bus/channels.cc`; a test compares the two. `_<V>` "
      "stands\n"
      "for a vehicle's name in upper case. Home is where a channel lives: in the `communities`\n"
      "layout each vehicle has an LCM port of its own, in the `shared` layout shore and vehicles\n"
      "have one together. Message types are in `lcmtypes/`. Channels that are not logged are made\n"
      "for eyes or for stepping.\n\n"
      "| channel | type | home | published by | subscribed to by | rate | logged |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const ChannelRow& row : ChannelTable()) {
    std::string_view home;
    switch (row.home) {
      case ChannelHome::kTickPort:
        home = "tick port";
        break;
      case ChannelHome::kDonePort:
        home = "done port";
        break;
      case ChannelHome::kShore:
        home = "shore";
        break;
      case ChannelHome::kVehicle:
        home = "vehicle";
        break;
    }
    text += fmt::format("| `{}{}` | `{}` | {} | {} | {} | {} | {} |\n", row.topic,
                        row.home == ChannelHome::kVehicle ? "_<V>" : "", row.type, home,
                        row.publishers, row.subscribers, row.rate, row.logged ? "yes" : "no");
  }
  return text;
}

}  // namespace shoal
