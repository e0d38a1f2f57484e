#include "lib/run/run/app_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/run/command_line/command.h"
#include "lib/run/run/log_arguments.h"

namespace shoal {

namespace {

/// True where `app` is one of the names in a comma-separated list ("every app" names all).
bool Names(std::string_view list, std::string_view app) {
  if (list == "every app" || list == "every participant" || list == "participants") return true;
  for (size_t begin = 0; begin < list.size();) {
    const size_t end = std::min(list.find(", ", begin), list.size());
    if (list.substr(begin, end - begin) == app) return true;
    begin = end + 2;
  }
  return false;
}

std::string Rows(std::string_view app, bool published) {
  std::string text;
  for (const ChannelRow& row : ChannelTable()) {
    if (!Names(published ? row.publishers : row.subscribers, app)) continue;
    const std::string channel =
        std::string(row.topic) + (row.home == ChannelHome::kVehicle ? "_<VEHICLE>" : "");
    text += fmt::format("  {:<26} {:<16} {}\n", channel, row.type, row.rate);
  }
  return text.empty() ? "  nothing\n" : text;
}

}  // namespace

std::string InterfaceText(const AppInfo& info) {
  if (info.name == "recorder") {
    return "SUBSCRIPTIONS:\n  every channel of every bus of the mission\nPUBLICATIONS:\n" +
           Rows(info.name, true);
  }
  return fmt::format("SUBSCRIPTIONS:\n{}\nPUBLICATIONS:\n{}", Rows(info.name, false),
                     Rows(info.name, true));
}

AppOptions ParseAppOptionsOrExit(const AppInfo& info, int argc, char** argv) {
  AppOptions options;
  std::string layout;
  bool example = false;
  bool interface = false;
  const std::string by_hand =
      info.name == "recorder"
          ? ""
          : fmt::format(
                "; started by a user it joins a mission that waits for it ({} = \"hand\" in the "
                "mission file)",
                info.name);
  // The short names are those of MOOS apps.
  Program program(info.name, fmt::format("{}\n`shoal run` starts it{}.", info.purpose, by_hand),
                  "-v,--version");
  program.AddFlag("-e,--example", &example, "Print a commented configuration block, then exit");
  program.AddFlag("-i,--interface", &interface,
                  "Print the channels that it subscribes to and publishes, then exit");
  program.AddOption("--mission", &options.mission_file, "Mission file");
  if (info.per_vehicle) {
    program.AddOption("--vehicle", &options.vehicle, "Vehicle that it works for");
  }
  program
      .AddOption("--set", &options.overrides, "Override a key of the mission file: key.path=value")
      .Repeatable();
  program.AddOption("--alias", &options.alias, "Name on the bus, instead of the usual one");
  program
      .AddOption("--port", &options.port_base,
                 "First port of the mission (default: found by the mission file)")
      .InRange(1024, 65535);
  program.AddOption("--layout", &layout, "shared or communities (default: as the running mission)")
      .OneOf({"shared", "communities"});
  program.AddOption("--mission-id", &options.mission_id,
                    "Reject messages of any other mission (default: that of the first tick)");
  if (info.can_live) {
    program.AddFlag(
        "--live", &options.live,
        "Work without a mission's clock: take messages as they come, by the wall's time");
  }
  if (info.name == "recorder") {
    program.AddOption("--log", &options.log_path, "Log file to write");
    AddChannelChoice(program, &options.log_channels);
  }
  program
      .AddOption("--lose", &options.lose,
                 "Fault injection: lose this share of incoming datagrams, to see them repaired")
      .InRange(0.0, 1.0);
  program.AddOption("--lose-forever", &options.lose_forever,
                    "Fault injection: lose every datagram of this channel, to see the mission end");
  program.ParseOrExit(argc, argv);
  if (example) {
    std::fputs(info.example.c_str(), stdout);
    std::exit(kExitOk);
  }
  if (interface) {
    std::fputs(InterfaceText(info).c_str(), stdout);
    std::exit(kExitOk);
  }
  if (options.mission_file.empty() || (info.per_vehicle && options.vehicle.empty())) {
    fmt::print(stderr, "{}: --mission FILE{} is needed; see {} --help\n", info.name,
               info.per_vehicle ? " and --vehicle NAME" : "", info.name);
    std::exit(kExitUsage);
  }
  if (info.name == "recorder" && options.log_path.empty()) {
    fmt::print(stderr, "recorder: --log FILE is needed; see recorder --help\n");
    std::exit(kExitUsage);
  }
  if (options.alias.size() > 64) {
    fmt::print(stderr, "{}: --alias is longer than 64 characters\n", info.name);
    std::exit(kExitUsage);
  }
  if (!layout.empty()) {
    options.layout = layout == "shared" ? Layout::kShared : Layout::kCommunities;
  }
  return options;
}

}  // namespace shoal
