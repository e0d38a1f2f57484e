#include "sim/simulation.h"

#include <fmt/format.h>

#include <utility>

#include "lib/mission/file/drawn_seed.h"
#include "lib/run/run/roster.h"
#include "sim/director_app.h"
#include "sim/mission_part.h"

namespace shoal {

struct Simulation::State {
  State(const Mission& from, const std::string& log_path, const ChannelChoice& log_channels)
      : mission(from), part(mission, OnePart(mission), 0, log_path, log_channels) {}

  const Mission mission;
  MissionPart part;
  bool has_ended = false;
};

Simulation::Simulation(const Mission& mission, const std::string& log_path,
                       const ChannelChoice& log_channels)
    : state_(std::make_unique<State>(mission, log_path, log_channels)) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Result<Simulation> Simulation::Open(const SimulationOptions& options) {
  std::vector<std::string> overrides = options.overrides;
  if (options.seed) overrides.push_back(fmt::format("mission.seed={}", *options.seed));
  const LoadedMission loaded = LoadMissionToRun(options.mission_file, DrawSeed, &overrides);
  if (!loaded.errors.empty()) return Error{fmt::format("{}", fmt::join(loaded.errors, "\n"))};
  if (const auto can = CanRunInOneProcess(loaded.mission); !can.ok()) return Error{can.error()};
  Simulation simulation(loaded.mission, options.log_path, options.log_channels);
  if (const std::string fault = simulation.Fault(); !fault.empty()) return Error{fault};
  return simulation;
}

bool Simulation::Step() {
  State& state = *state_;
  if (state.has_ended) return false;
  if (!state.part.MustEnd()) {
    state.part.Step();
    state.part.Decide();
    if (!state.part.ends_by_loss()) return true;
  }
  End();
  return false;
}

void Simulation::End() {
  State& state = *state_;
  if (state.has_ended) return;
  state.has_ended = true;
  state.part.End();
}

Bus& Simulation::bus() { return *state_->part.embedder(); }
std::string Simulation::Fault() const { return state_->part.Fault(); }
const std::vector<std::string>& Simulation::losses() const { return state_->part.losses(); }
int64_t Simulation::step() const { return state_->part.step(); }
int64_t Simulation::utime() const { return state_->part.utime(); }
const Mission& Simulation::mission() const { return state_->mission; }
const DirectorApp& Simulation::director() const { return *state_->part.director(); }
bool Simulation::Passed() const { return director().Passed(); }
std::string Simulation::Summary(bool complete) const { return director().Summary(complete); }
int64_t Simulation::num_delivered() const { return director().num_delivered(); }
int64_t Simulation::num_blocked() const { return director().num_blocked(); }

Result<bool> CanRunInOneProcess(const Mission& mission) {
  if (mission.netsim) {
    return Error{
        fmt::format("{}: the clients of [netsim] run in wall time, so the mission "
                    "needs `shoal run`",
                    mission.file)};
  }
  for (const RosterEntry& entry : MakeRoster(mission, false)) {
    if (entry.provider == Provider::kHand || !entry.command.empty()) {
      return Error{fmt::format(
          "{}: {} is not one of shoal's own processes, so the mission needs `shoal run`",
          mission.file, entry.name)};
    }
  }
  return true;
}

}  // namespace shoal
