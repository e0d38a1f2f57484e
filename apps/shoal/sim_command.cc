#include "apps/shoal/sim_command.h"

#include <fmt/format.h>
#include <signal.h>

#include <atomic>
#include <filesystem>

#include "apps/shoal/whole_mission.h"
#include "lib/mission/load.h"
#include "lib/run/run_app.h"

namespace shoal {

namespace {

std::atomic<bool> interrupted = false;

constexpr int64_t kStepsBetweenChecks = 256;

}  // namespace

int RunSim(const SimOptions& options) {
  const LoadedMission loaded = LoadMission(options.mission_file, options.overrides);
  for (const std::string& error : loaded.errors) fmt::print(stderr, "{}\n", error);
  if (!loaded.errors.empty()) return kExitUsage;
  const Mission& mission = loaded.mission;
  if (const auto can = CanRunInOneProcess(mission); !can.ok()) {
    fmt::print(stderr, "shoal: {}\n", can.error());
    return kExitUsage;
  }
  if (std::error_code error; std::filesystem::is_directory(options.log_path, error)) {
    fmt::print(stderr, "shoal: --log {} is a folder; name a file\n", options.log_path);
    return kExitUsage;
  }
  signal(SIGINT, [](int) { interrupted = true; });
  signal(SIGTERM, [](int) { interrupted = true; });

  WholeMission whole(mission, options.log_path);
  const int64_t begin = MonotonicMicroseconds();
  std::string fault;
  while (whole.Step()) {
    if (whole.step() % kStepsBetweenChecks != 0) continue;
    fault = whole.Fault();
    if (interrupted || !fault.empty()) break;
  }
  whole.End();
  if (fault.empty()) fault = whole.Fault();
  const double wall_s = static_cast<double>(MonotonicMicroseconds() - begin) / 1e6;
  const double mission_s = static_cast<double>(whole.step() * mission.tick_us) / 1e6;

  if (!options.quiet) {
    fmt::print("{:.1f} s of mission in {:.3f} s ({:.0f} x real time), one process\n", mission_s,
               wall_s, mission_s / std::max(wall_s, 1e-6));
    if (!options.log_path.empty()) fmt::print("Log: {}\n", options.log_path);
    fmt::print("\n{}", whole.director().Summary(!interrupted && fault.empty()));
  } else {
    fmt::print("{}\n", whole.director().Passed() ? "PASS" : "FAIL");
  }
  if (!fault.empty()) {
    fmt::print(stderr, "shoal: {}\n", fault);
    return kExitEnvironment;
  }
  if (interrupted) {
    fmt::print(stderr, "shoal: interrupted; the mission did not run to its end\n");
    return kExitMissionFailed;
  }
  return whole.director().Passed() ? kExitOk : kExitMissionFailed;
}

}  // namespace shoal
