#include "sim/run_sim.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "lib/mission/file/drawn_seed.h"
#include "lib/mission/file/print_errors.h"
#include "lib/run/run/log_plan.h"
#include "lib/run/run/run_app.h"
#include "sim/director_app.h"
#include "sim/sim_ending.h"
#include "sim/simulation.h"

namespace shoal {

namespace {

std::atomic<bool> interrupted = false;

constexpr int64_t kStepsBetweenChecks = 64;  ///< Of the clock, signals and faults.
constexpr int64_t kProgressInterval_us = 500'000;
constexpr char kClearLine[] = "\r\033[K";

/// A line on a terminal that shows how far the mission is; elsewhere nothing.
class ProgressLine {
 public:
  explicit ProgressLine(const Mission& mission) : mission_(mission) {}

  void Show(const Simulation& simulation, int64_t wall_us) {
    if (!on_terminal_ || wall_us < next_us_) return;
    next_us_ = wall_us + kProgressInterval_us;
    const double mission_s = static_cast<double>(simulation.step() * mission_.tick_us) / 1e6;
    const double wall_s = std::max(static_cast<double>(wall_us - begin_us_) / 1e6, 1e-3);
    fmt::print(
        "{}{:8.1f} of {:.1f} s  {:6.1f} x real time  {} vehicles  {} reports delivered, "
        "{} blocked",
        kClearLine, mission_s, mission_.duration_s, mission_s / wall_s, mission_.vehicles.size(),
        simulation.num_delivered(), simulation.num_blocked());
    std::fflush(stdout);
    is_shown_ = true;
  }

  void Clear() {
    if (is_shown_) fmt::print("{}", kClearLine);
    if (is_shown_) std::fflush(stdout);
    is_shown_ = false;
  }

 private:
  const Mission& mission_;
  const bool on_terminal_ = isatty(STDOUT_FILENO) == 1;
  const int64_t begin_us_ = MonotonicMicroseconds();
  int64_t next_us_ = begin_us_ + kProgressInterval_us;
  bool is_shown_ = false;
};

}  // namespace

int RunSim(const SimOptions& options) {
  std::vector<std::string> overrides = options.overrides;
  const LoadedMission loaded = LoadMissionToRun(options.mission_file, DrawSeed, &overrides);
  if (!LoadedWithoutErrors(loaded)) return kExitUsage;
  const Mission& mission = loaded.mission;
  if (overrides.size() > options.overrides.size()) {
    fmt::print("Drawn: --set {}\n", overrides.back());
    std::fflush(stdout);
  }
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

  if (!options.log_path.empty()) {
    const LogPlan plan = PlanLog(mission, options.log_channels, options.log_path);
    for (const std::string& warning : plan.warnings) fmt::print(stderr, "shoal: {}\n", warning);
  }
  Simulation simulation(mission, options.log_path, options.log_channels);
  std::string fault = simulation.Fault();
  if (!fault.empty()) {
    fmt::print(stderr, "shoal: {}\n", fault);
    return kExitEnvironment;
  }
  ProgressLine progress(mission);
  const int64_t begin = MonotonicMicroseconds();
  while (simulation.Step()) {
    if (simulation.step() % kStepsBetweenChecks != 0) continue;
    fault = simulation.Fault();
    if (interrupted || !fault.empty()) break;
    if (!options.quiet) progress.Show(simulation, MonotonicMicroseconds());
  }
  simulation.End();
  if (fault.empty()) fault = simulation.Fault();
  const double wall_s = static_cast<double>(MonotonicMicroseconds() - begin) / 1e6;

  progress.Clear();
  return PrintEnding({.mission = mission,
                      .director = simulation.director(),
                      .step = simulation.step(),
                      .wall_s = wall_s,
                      .where = "one process",
                      .log_path = options.log_path,
                      .losses = simulation.losses(),
                      .fault = fault,
                      .was_interrupted = interrupted});
}

}  // namespace shoal
