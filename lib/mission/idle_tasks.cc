// Warns of tasks that a vehicle never comes to.
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "lib/mission/describe.h"
#include "lib/mission/suggest.h"

namespace shoal {
namespace {

struct EndsNever {
  bool operator()(const WaypointsTask& task) const { return task.laps == 0; }
  bool operator()(const LoiterTask& task) const { return task.duration_s == 0; }
  bool operator()(const StationKeepTask&) const { return true; }
  bool operator()(const ReturnTask&) const { return true; }
  bool operator()(const PathFollowTask& task) const {
    return task.end != PathTaskEnd::kDone && task.end != PathTaskEnd::kSurface;
  }
  bool operator()(const TargetTrackTask&) const { return true; }
};

/// Returns the tasks that events start by their names.
std::set<std::string_view> TasksOfEvents(const Mission& mission, const Vehicle& vehicle) {
  std::set<std::string_view> names;
  for (const Event& event : mission.events) {
    const auto* command = std::get_if<CommandEvent>(&event.what);
    if (command == nullptr || command->command != "task") continue;
    if (command->vehicle == "all" || command->vehicle == vehicle.name) {
      names.insert(command->argument);
    }
  }
  return names;
}

}  // namespace

void WarnOfIdleTasks(Fields& file, const Mission& mission) {
  if (!file.reading()) return;
  const auto keep_count = [](size_t) {};
  file.EachBelow("vehicle", 0, keep_count, [&](Fields& fields, size_t i) {
    fields.SkipRest();
    if (i >= mission.vehicles.size()) return;
    const Vehicle& vehicle = mission.vehicles[i];
    const std::set<std::string_view> started = TasksOfEvents(mission, vehicle);
    const Task* endless = nullptr;  // Nothing comes after it by itself.
    fields.EachBelow("task", 0, keep_count, [&](Fields& table, size_t k) {
      table.SkipRest();
      if (k >= vehicle.tasks.size()) return;
      const Task& task = vehicle.tasks[k];
      if (started.contains(task.name)) endless = nullptr;
      if (endless != nullptr) {
        table.Warn("", "the task " + Quoted(task.name) + " is never reached: " +
                           Quoted(endless->name) + " before it never ends, and no event starts it");
      } else if (std::visit(EndsNever(), task.what)) {
        endless = &task;
      }
    });
  });
}

}  // namespace shoal
