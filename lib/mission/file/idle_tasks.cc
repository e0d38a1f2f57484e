// Warns of tasks that a vehicle never reaches.
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/mission/file/validate.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

/// Returns the tasks that events start by their names.
std::set<std::string_view> TasksOfEvents(const Mission& mission, const Vehicle& vehicle) {
  std::set<std::string_view> names;
  for (const Event& event : mission.events) {
    const auto* command = std::get_if<CommandEvent>(&event.what);
    if (command == nullptr || command->command != "task") continue;
    const std::vector<const Vehicle*> named = mission.VehiclesNamed(command->vehicle);
    if (std::find(named.begin(), named.end(), &vehicle) != named.end()) {
      names.insert(command->argument);
    }
  }
  return names;
}

}  // namespace

void WarnOfIdleTasks(const Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    const std::set<std::string_view> started = TasksOfEvents(mission, vehicle);
    const Task* endless = nullptr;  // Nothing comes after it by itself.
    for (size_t k = 0; k < vehicle.tasks.size(); ++k) {
      const Task& task = vehicle.tasks[k];
      if (started.contains(task.name)) endless = nullptr;
      if (endless != nullptr) {
        file.Below("vehicle", i)
            .Below("task", k)
            .Warn("", "the task " + Quoted(task.name) + " is never reached: " +
                          Quoted(endless->name) + " before it never ends, and no event starts it");
      } else if (!FactsOf(task).ends) {
        endless = &task;
      }
    }
  }
}

}  // namespace shoal
