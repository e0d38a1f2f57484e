// The main loop of a participant that runs in a process of its own.
//
//   int RunHelm(int argc, char** argv) {
//     return RunVehicleApp(kInfo, argc, argv, [](const auto& mission, const auto& vehicle, auto&
//     bus,
//                                                const auto&) {
//       return std::make_unique<HelmApp>(mission, vehicle, bus);
//     });
//   }
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/app.h"
#include "lib/run/run/app_options.h"

namespace shoal {

/// Makes the app of one vehicle.
using VehicleAppFactory = std::function<std::unique_ptr<App>(
    const Mission& mission, const Vehicle& vehicle, Bus& bus, const AppOptions& options)>;
/// Makes an app of the whole mission.
using MissionAppFactory = std::function<std::unique_ptr<App>(const Mission& mission, Bus& bus,
                                                             const AppOptions& options)>;

/// Parses the command line, loads the mission, joins its bus and steps the app until the mission
/// ends or a signal comes. Returns the exit code (lib/base/check/result.h).
int RunVehicleApp(const AppInfo& info, int argc, char** argv, const VehicleAppFactory& make);
int RunMissionApp(const AppInfo& info, int argc, char** argv, const MissionAppFactory& make);

/// One participant of a process, and how its app is made.
struct Joining {
  std::string name;  ///< On the bus.
  std::function<std::unique_ptr<App>(Bus&)> make;
};

/// Joins the bus of `mission` with all of `joining`, and steps them until the mission ends or a
/// signal comes. `title` names the process on its terminal and in errors. Returns the exit code.
/// @pre `joining` is not empty
int RunJoined(const AppOptions& options, const std::string& title, const Mission& mission,
              const std::vector<Joining>& joining);

/// Loads the mission of a process that takes part in it, or prints all that is wrong with it.
std::optional<Mission> LoadToTakePart(const AppOptions& options);

/// The terminal shows an app's page this often.
inline constexpr int64_t kTerminalInterval_us = 1'000'000;

/// Returns microseconds of a clock that never jumps. For the rim only: apps are given their time.
int64_t MonotonicMicroseconds();
/// Returns microseconds since 1970, which jump when the clock is set.
int64_t UnixMicroseconds();
/// Returns the processor time that this thread has used, in microseconds.
int64_t ProcessorMicroseconds();

/// Returns how long a participant asks for missing messages: less than the clock waits for it.
int64_t GiveUpAfter_us(const Mission& mission);

/// Returns a filter that loses datagrams as --lose and --lose-forever ask for; empty: none.
std::function<bool(std::string_view channel)> MakeLossFilter(double lose,
                                                             const std::string& lose_forever);

}  // namespace shoal
