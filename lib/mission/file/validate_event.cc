// Whether the vehicles of an [[event]] or [[order]] have the tasks and groups that it names, and
// whether an order's name means nothing else.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/comms/routing/control.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/model/names.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

/// Refuses the argument of `task` where one of the vehicles has no task of that name.
void CheckTaskArgument(const CommandEvent& event, const Mission& mission, const TablePlace& place) {
  if (event.command != "task" || event.argument.empty()) return;
  for (const Vehicle* vehicle : VehiclesNamed(mission, event.vehicle)) {
    std::vector<std::string_view> names;
    for (const Task& task : vehicle->tasks) names.push_back(task.name);
    if (std::find(names.begin(), names.end(), event.argument) != names.end()) continue;
    place.Refuse("argument",
                 fmt::format("{} has no task {}{}", vehicle->name, Quoted(event.argument),
                             DidYouMean(event.argument, names)));
    return;
  }
}

/// Warns of a group without members; a group may have some that come from outside.
void CheckGroup(const MessageEvent& event, const Mission& mission, const TablePlace& place) {
  const std::string group = LowerCase(event.dest_group);
  if (group.empty() || group == "all") return;
  std::vector<std::string_view> groups;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (LowerCase(vehicle.group) == group) return;
    if (!vehicle.group.empty()) groups.push_back(vehicle.group);
  }
  place.Warn("dest_group",
             fmt::format("no vehicle of the mission is of group {}{}", Quoted(event.dest_group),
                         DidYouMean(event.dest_group, groups)));
}

/// `shoal send` knows orders by names that mean nothing else.
void CheckOrderName(const std::string& name, const Mission& mission, const TablePlace& place) {
  if (name.empty()) return;  // Which its key refuses.
  std::string problem = NameProblem(name);
  if (mission.FindVehicle(name) != nullptr) problem = "is a vehicle";
  if (FindControl(name) != nullptr) problem = "is a rule of the broker";
  if (name == "clock" || name == "all") problem = "means another target of `shoal send`";
  if (problem.empty()) return;
  place.Refuse("name", fmt::format("no order can be called {}: {}; give it another name",
                                   Quoted(name), problem));
}

}  // namespace

void ValidateEvents(const Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.events.size(); ++i) {
    const TablePlace place = file.Below("event", i);
    if (const auto* command = std::get_if<CommandEvent>(&mission.events[i].what)) {
      CheckTaskArgument(*command, mission, place);
    } else if (const auto* message = std::get_if<MessageEvent>(&mission.events[i].what)) {
      CheckGroup(*message, mission, place.Below("message"));
    }
  }
  for (size_t i = 0; i < mission.orders.size(); ++i) {
    const TablePlace place = file.Below("order", i);
    CheckOrderName(mission.orders[i].name, mission, place);
    CheckTaskArgument(mission.orders[i].command, mission, place);
  }
}

}  // namespace shoal
