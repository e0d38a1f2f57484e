#include "apps/shoal/whole_mission.h"

#include <fmt/format.h>

#include "apps/shoal/app_factory.h"
#include "lib/run/roster.h"

namespace shoal {

WholeMission::WholeMission(const Mission& mission, const std::string& log_path)
    : mission_(mission) {
  const auto add = [&](Bus& bus, std::unique_ptr<App> app) {
    members_.push_back({.bus = &bus, .app = std::move(app)});
  };
  if (!log_path.empty()) {
    Bus& bus = hub_.Join("recorder");
    add(bus, std::make_unique<RecorderApp>(
                 RecorderOptions{.path = log_path, .start_utime = mission.start_utime}, bus));
  }
  for (const RosterEntry& entry : MakeRoster(mission, false)) {
    Bus& bus = hub_.Join(entry.name);
    add(bus, MakeApp(entry, mission, bus));
  }
  Bus& bus = hub_.Join("shoal");
  auto director = std::make_unique<DirectorApp>(mission, bus);
  director_ = director.get();
  add(bus, std::move(director));
}

bool WholeMission::Step() {
  if (ended_) return false;
  if (step_ == mission_.LastStep()) {
    End();
    return false;
  }
  ++step_;
  hub_.NextStep();
  const int64_t utime = mission_.UtimeOf(step_);
  for (const Member& member : members_) {
    hub_.Handle(*member.bus);
    member.app->Tick(utime);
  }
  return true;
}

void WholeMission::End() {
  if (ended_) return;
  ended_ = true;
  hub_.NextStep();
  for (const Member& member : members_) {
    hub_.Handle(*member.bus);
    member.app->End();
  }
}

std::string WholeMission::Fault() const {
  for (const Member& member : members_) {
    if (std::string fault = member.app->Fault(); !fault.empty()) return fault;
  }
  return {};
}

Result<bool> CanRunInOneProcess(const Mission& mission) {
  if (mission.netsim) {
    return Error{fmt::format("{}: the clients of [netsim] live by the wall's clock, so the mission "
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
