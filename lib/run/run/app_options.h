// The command line that all of shoal's own participants share: each reads what it needs from the
// mission file, so none has options of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/bus/bus/layout.h"
#include "lib/bus/record/channel_choice.h"

namespace shoal {

struct Mission;
struct Vehicle;

/// What --help, --example and --interface of an app show.
struct AppInfo {
  std::string name;     ///< "helm"
  std::string purpose;  ///< One or two sentences.
  bool per_vehicle = true;
  bool can_live = false;  ///< Works without a mission's clock too: --live.
  std::string example;    ///< A commented block of a mission file.
  /// Returns why the mission has no use for the app at this vehicle; empty: it has.
  std::string (*misfit)(const Mission& mission, const Vehicle& vehicle) = nullptr;
};

struct AppOptions {
  std::string mission_file;
  std::vector<std::string> overrides;  ///< --set
  std::string vehicle;
  std::string alias;  ///< Name on the bus; empty: <app>_<vehicle>.
  int port_base = 0;  ///< 0: that of the running mission of this file.
  std::optional<Layout> layout;
  int64_t mission_id = 0;
  bool live = false;           ///< Without a mission's clock: lib/run/run/live.h.
  std::string log_path;        ///< Recorder only.
  ChannelChoice log_channels;  ///< Recorder only.
  double lose = 0;             ///< Share of incoming datagrams lost on purpose.
  std::string lose_forever;    ///< A channel whose datagrams are all lost on purpose.
};

/// Parses the command line; handles --help, --version, --example and --interface; exits with 0 or
/// kExitUsage where there is nothing more to do.
AppOptions ParseAppOptionsOrExit(const AppInfo& info, int argc, char** argv);

/// Returns which channels an app subscribes to and publishes, from the channel table.
std::string InterfaceText(const AppInfo& info);

}  // namespace shoal
