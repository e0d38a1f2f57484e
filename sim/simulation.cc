#include "sim/simulation.h"

#include <fmt/format.h>

#include <utility>

#include "apps/recorder/recorder_app.h"
#include "lib/bus/memory_bus.h"
#include "lib/mission/drawn_seed.h"
#include "lib/run/roster.h"
#include "sim/app_factory.h"
#include "sim/director_app.h"

namespace shoal {

namespace {

constexpr int kMaxRestarts = 5;  ///< Of one participant, as in `shoal run`.

/// Asks for the first lines of an object, where apps and buses keep what every step needs: a step
/// meets each of thousands of participants once, after the caches have forgotten it.
void Prefetch(const void* object) {
  constexpr uintptr_t kLine_bytes = 64;
  constexpr uintptr_t kLines = 10;
  const auto begin = reinterpret_cast<uintptr_t>(object);
  for (uintptr_t i = 0; i < kLines; ++i) {
    __builtin_prefetch(reinterpret_cast<const void*>(begin + i * kLine_bytes));
  }
}

}  // namespace

struct Simulation::State {
  struct Member {
    Bus* bus = nullptr;
    std::unique_ptr<App> app;               ///< Null: the embedding program, or it was lost.
    std::optional<RosterEntry> entry = {};  ///< Of those that can be started again.
    int num_restarts = 0;
  };

  explicit State(const Mission& from) : mission(from) {}

  void Add(Bus& bus, std::unique_ptr<App> app, std::optional<RosterEntry> entry = {}) {
    members.push_back({.bus = &bus, .app = std::move(app), .entry = std::move(entry)});
  }

  /// As the supervision of `shoal run` does with a process that died.
  void Lose(Member* member, const std::string& how) {
    const std::string name = member->entry ? member->entry->name : "a participant";
    hub.EndSubscriptions(*member->bus);
    member->app.reset();
    if (mission.on_loss == OnLoss::kEnd) {
      fault = fmt::format("LOST: {}: {}; the mission ends without it", name, how);
    } else if (mission.on_loss == OnLoss::kContinue || !member->entry) {
      losses.push_back(fmt::format("LOST: {}: {}; the mission goes on without it", name, how));
    } else if (++member->num_restarts > kMaxRestarts) {
      fault = fmt::format("{}: {}; it was restarted {} times already", name, how, kMaxRestarts);
    } else {
      member->app = MakeApp(*member->entry, mission, *member->bus);
      losses.push_back(fmt::format("LOST: {}: {}; it starts again", name, how));
    }
  }

  const Mission mission;
  MemoryBus hub;
  std::vector<Member> members;
  Bus* embedder = nullptr;
  DirectorApp* director = nullptr;
  int64_t step = -1;
  bool has_ended = false;
  std::string fault;  ///< Of a loss that ends the mission.
  std::vector<std::string> losses;
};

Simulation::Simulation(const Mission& mission, const std::string& log_path)
    : state_(std::make_unique<State>(mission)) {
  State& state = *state_;
  if (!log_path.empty()) {
    Bus& bus = state.hub.Join("recorder");
    state.Add(bus, std::make_unique<RecorderApp>(
                       RecorderOptions{.path = log_path, .start_utime = mission.start_utime}, bus));
  }
  for (const RosterEntry& entry : MakeRoster(state.mission, false)) {
    Bus& bus = state.hub.Join(entry.name);
    state.Add(bus, MakeApp(entry, state.mission, bus), entry);
  }
  Bus& bus = state.hub.Join("shoal");
  auto director = std::make_unique<DirectorApp>(state.mission, bus);
  state.director = director.get();
  state.Add(bus, std::move(director));
  state.embedder = &state.hub.Join("embedder");
  state.Add(*state.embedder, nullptr);
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Result<Simulation> Simulation::Open(const SimulationOptions& options) {
  std::vector<std::string> overrides = options.overrides;
  if (options.seed) overrides.push_back(fmt::format("mission.seed={}", *options.seed));
  const LoadedMission loaded = LoadMissionToRun(options.mission_file, DrawSeed, &overrides);
  if (!loaded.errors.empty()) return Error{fmt::format("{}", fmt::join(loaded.errors, "\n"))};
  if (const auto can = CanRunInOneProcess(loaded.mission); !can.ok()) return Error{can.error()};
  Simulation simulation(loaded.mission, options.log_path);
  if (const std::string fault = simulation.Fault(); !fault.empty()) return Error{fault};
  return simulation;
}

bool Simulation::Step() {
  State& state = *state_;
  if (state.has_ended) return false;
  if (state.step == state.mission.LastStep() || state.director->EndsMission()) {
    End();
    return false;
  }
  ++state.step;
  state.hub.NextStep();
  constexpr size_t kAhead = 2;
  for (size_t i = 0; i < state.members.size(); ++i) {
    if (i + kAhead < state.members.size()) {
      Prefetch(state.members[i + kAhead].bus);
      Prefetch(state.members[i + kAhead].app.get());
    }
    State::Member& member = state.members[i];
    state.hub.Handle(*member.bus);
    if (!member.app) continue;
    member.app->Tick(utime());
    if (const std::string how = member.app->Crash(); !how.empty()) state.Lose(&member, how);
  }
  if (state.fault.empty()) return true;
  End();
  return false;
}

void Simulation::End() {
  State& state = *state_;
  if (state.has_ended) return;
  state.has_ended = true;
  state.hub.NextStep();
  for (const State::Member& member : state.members) {
    state.hub.Handle(*member.bus);
    if (member.app) member.app->End();
  }
}

Bus& Simulation::bus() { return *state_->embedder; }

std::string Simulation::Fault() const {
  if (!state_->fault.empty()) return state_->fault;
  for (const State::Member& member : state_->members) {
    if (!member.app) continue;
    if (std::string fault = member.app->Fault(); !fault.empty()) return fault;
  }
  return {};
}

const std::vector<std::string>& Simulation::losses() const { return state_->losses; }
int64_t Simulation::step() const { return state_->step; }
int64_t Simulation::utime() const { return state_->mission.UtimeOf(state_->step); }
const Mission& Simulation::mission() const { return state_->mission; }
bool Simulation::Passed() const { return state_->director->Passed(); }
std::string Simulation::Summary(bool complete) const { return state_->director->Summary(complete); }
int64_t Simulation::num_delivered() const { return state_->director->num_delivered(); }
int64_t Simulation::num_blocked() const { return state_->director->num_blocked(); }
const DirectorApp& Simulation::director() const { return *state_->director; }

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
