// What the behaviors of a vehicle need of each other, of its tasks, of its model and of the others.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/base/text/blanks.h"
#include "lib/helm/behaviors/behavior_runner.h"
#include "lib/helm/behaviors/contact_recipe.h"
#include "lib/helm/behaviors/reported_variables.h"
#include "lib/helm/modes/flag.h"
#include "lib/helm/modes/value_text.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

template <class... Kinds>
bool IsOneOf(const AnyBehavior& what) {
  return (std::holds_alternative<Kinds>(what) || ...);
}

bool IsAboutDepth(const AnyBehavior& what) {
  return IsOneOf<ConstantDepthOptions, GoToDepthOptions, MaxDepthOptions, MinAltitudeOptions,
                 PeriodicSurfaceOptions>(what);
}

/// True for behaviors which can lead a vessel somewhere, or keep it where it is.
bool GivesSpeed(const AnyBehavior& what) {
  return IsOneOf<WaypointOptions, LoiterOptions, StationKeepOptions, ConstantSpeedOptions,
                 TrailOptions, ShadowOptions, CutRangeOptions, ConvoyOptions, LegRunOptions,
                 PeriodicSpeedOptions, PeriodicSurfaceOptions, FixedTurnOptions, ZigzagOptions,
                 FullStopOptions, RubberBandOptions>(what);
}

void CheckNames(const Vehicle& vehicle, const TablePlace& place) {
  const auto& behaviors = vehicle.behaviors;
  for (size_t i = 0; i < behaviors.size(); ++i) {
    for (size_t k = 0; k < behaviors.size(); ++k) {
      const std::string& name = behaviors[i].name;
      const std::string& other = behaviors[k].name;
      if (i == k || name.empty() || !other.starts_with(name)) continue;
      if (name == other && k > i) continue;  // Refused at the later one.
      place.Below("behavior", i)
          .Refuse("name", name == other
                              ? fmt::format("a behavior {} of this vehicle exists already; give "
                                            "each a name of its own",
                                            Quoted(name))
                              : fmt::format("the name {} is the beginning of {}: pages and updates "
                                            "would mix them up; give it another",
                                            Quoted(name), Quoted(other)));
      break;
    }
  }
}

void CheckDepth(const Vehicle& vehicle, const TablePlace& place) {
  if (FactsOfModel(vehicle.model).is_underwater || vehicle.domain.depth_m.count > 0) return;
  for (size_t i = 0; i < vehicle.behaviors.size(); ++i) {
    const AnyBehavior& what = vehicle.behaviors[i].what;
    if (!IsAboutDepth(what)) continue;
    place.Below("behavior", i)
        .Refuse("kind", fmt::format("{} is about depth, and a {} does not dive: take another model "
                                    "or leave it out",
                                    KindOf(what), FactsOfModel(vehicle.model).name));
  }
}

void CheckOthers(const Mission& mission, const Vehicle& vehicle, const TablePlace& place) {
  const auto reports_to_it = [&](const Vehicle& other) {
    return other.name != vehicle.name && mission.IsReported(other);
  };
  for (size_t i = 0; i < vehicle.behaviors.size(); ++i) {
    const BehaviorOptions& behavior = vehicle.behaviors[i];
    const TablePlace table = place.Below("behavior", i);
    if (const ContactOptions* contact = ContactOptionsOf(behavior.what)) {
      if (!contact->contact.empty() && contact->contact == vehicle.name) {
        table.Refuse("contact", "a vehicle is not a contact of its own");
      } else if (!std::any_of(mission.vehicles.begin(), mission.vehicles.end(), reports_to_it) &&
                 !vehicle.sonar.is_fitted) {
        table.Warn("", fmt::format("{} never has a contact: no other vehicle reports its position",
                                   behavior.name));
      }
    }
    const auto* avoid = std::get_if<AvoidObstacleOptions>(&behavior.what);
    if (avoid == nullptr) continue;
    const bool is_known = std::any_of(mission.obstacles.begin(), mission.obstacles.end(),
                                      [&](const Obstacle& each) { return each.id == avoid->id; });
    if (!avoid->id.empty() && avoid->polygon.empty() && !is_known) {
      table.Refuse("id", fmt::format("no [[obstacle]] has the id {}", Quoted(avoid->id)));
    } else if (behavior.templating != Templating::kNone && mission.obstacles.empty()) {
      table.Warn("",
                 fmt::format("{} never begins: the mission has no [[obstacle]]", behavior.name));
    }
  }
}

void WarnOfSpeed(const Vehicle& vehicle, const TablePlace& place) {
  const auto gives_speed = [](const BehaviorOptions& each) { return GivesSpeed(each.what); };
  if (vehicle.tasks.empty() &&
      !std::any_of(vehicle.behaviors.begin(), vehicle.behaviors.end(), gives_speed)) {
    place.Below("behavior", 0)
        .Warn("",
              "no task and no behavior gives this vehicle a speed, so it never moves: add a "
              "waypoint, a loiter, a constant_speed ...");
  }
  for (size_t i = 0; i < vehicle.behaviors.size(); ++i) {
    const BehaviorOptions& behavior = vehicle.behaviors[i];
    const TablePlace table = place.Below("behavior", i);
    const auto* waypoint = std::get_if<WaypointOptions>(&behavior.what);
    const auto* loiter = std::get_if<LoiterOptions>(&behavior.what);
    const bool rests = (waypoint != nullptr && waypoint->speed == 0 && !waypoint->use_alt_speed) ||
                       (loiter != nullptr && loiter->speed == 0 && !loiter->use_alt_speed);
    if (rests && behavior.updates.empty()) {
      table.Warn("speed", fmt::format("{} has speed = 0, so it leads nowhere", behavior.name));
    }
    if (behavior.templating != Templating::kNone && behavior.updates.empty() &&
        !AlertRangeOf(behavior.what) && !IsOneOf<AvoidObstacleOptions>(behavior.what)) {
      table.Warn("templating",
                 fmt::format("{} never begins: only avoid_collision, colregs and avoid_obstacle do "
                             "by themselves; write updates = \"VARIABLE\", and name = ... in its "
                             "texts",
                             behavior.name));
    }
  }
}

/// Names of all variables that the mission may set in this vehicle.
class SetVariables {
 public:
  SetVariables(const Mission& mission, const Vehicle& vehicle) {
    for (const auto& [name, value] : vehicle.variables) names_.insert(name);
    for (const ModeOptions& mode : vehicle.modes) {
      names_.emplace(Trimmed(std::string_view(mode.set).substr(0, mode.set.find('='))));
    }
    for (const Vehicle& each : mission.vehicles) {
      for (const BehaviorOptions& behavior : each.behaviors) {
        AddFlags(behavior, each.name == vehicle.name);
      }
    }
    for (const Event& event : mission.events) {
      if (const auto* command = std::get_if<CommandEvent>(&event.what)) {
        names_.emplace(
            Trimmed(std::string_view(command->argument).substr(0, command->argument.find('='))));
      } else if (const auto* message = std::get_if<MessageEvent>(&event.what)) {
        names_.insert(message->var_name);
      }
    }
  }

  bool Have(const std::string& name) const {
    return names_.contains(name) || IsReportedVariable(name);
  }

 private:
  void AddFlags(const BehaviorOptions& behavior, bool is_own) {
    const BehaviorFlags& common = behavior.flags;
    std::vector<const std::vector<std::string>*> lists = EachOwnFlags(behavior.what);
    for (const auto* list : {&common.runflag, &common.runxflag, &common.idleflag,
                             &common.activeflag, &common.inactiveflag, &common.endflag,
                             &common.spawnflag, &common.spawnxflag, &common.configflag}) {
      lists.push_back(list);
    }
    for (const auto* list : lists) {
      for (const std::string& text : *list) {
        const auto flag = Flag::Parse(text);
        if (flag.ok() && (is_own || !flag->destination().empty())) names_.insert(flag->variable());
      }
    }
    if (behavior.duration && is_own) names_.insert(behavior.duration_status);
    if (!is_own) return;
    for (std::string& name : NamedVariables(behavior.what)) names_.insert(std::move(name));
  }

  std::set<std::string> names_;
};

void WarnOfVariables(const Mission& mission, const Vehicle& vehicle, const TablePlace& place) {
  if (mission.MayBeSteeredFromOutside()) return;
  const SetVariables set(mission, vehicle);
  const auto check = [&](const TablePlace& table, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      const auto condition = Condition::Parse(text);
      if (!condition.ok()) continue;
      for (const std::string& name : condition->VariablesUsed()) {
        if (set.Have(name)) continue;
        table.Warn("condition",
                   fmt::format("nothing in the file sets {}, so {} is false until a user does: "
                               "write it in [vehicle.variables], or in an [[event]] with command = "
                               "\"set\"",
                               name, Quoted(text)));
      }
    }
  };
  for (size_t i = 0; i < vehicle.modes.size(); ++i) {
    check(place.Below("mode", i), vehicle.modes[i].condition);
  }
  for (size_t i = 0; i < vehicle.behaviors.size(); ++i) {
    const BehaviorOptions& behavior = vehicle.behaviors[i];
    // Which contact a recipe's condition names is known when one is spawned.
    const bool is_recipe = behavior.templating == Templating::kSpawn;
    check(place.Below("behavior", i), is_recipe ? behavior.condition : ConditionsOf(behavior));
  }
}

}  // namespace

void ValidateBehaviors(const Mission& mission, const TablePlace& file) {
  std::set<std::string> ids;
  for (size_t i = 0; i < mission.obstacles.size(); ++i) {
    const std::string& id = mission.obstacles[i].id;
    if (!id.empty() && !ids.insert(id).second) {
      file.Below("obstacle", i)
          .Refuse("id", fmt::format("an obstacle {} exists already; give each an id of its own",
                                    Quoted(id)));
    }
  }
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    const TablePlace place = file.Below("vehicle", i);
    CheckNames(vehicle, place);
    CheckDepth(vehicle, place);
    CheckOthers(mission, vehicle, place);
    if (vehicle.behaviors.empty()) {
      if (!vehicle.modes.empty()) {
        place.Below("mode", 0).Warn("", "modes have no effect without a [[vehicle.behavior]]");
      }
      continue;
    }
    if (vehicle.helm == Provider::kNone) {
      place.Below("behavior", 0).Warn("", "behaviors have no effect without a helm of shoal");
    }
    if (!file.IsSound()) continue;
    WarnOfSpeed(vehicle, place);
    WarnOfVariables(mission, vehicle, place);
  }
}

}  // namespace shoal
