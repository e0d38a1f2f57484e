#include "lib/tools/moos/import_outlook.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "lib/base/text/blanks.h"
#include "lib/helm/behaviors/behavior_runner.h"
#include "lib/helm/behaviors/behavior_set.h"
#include "lib/helm/modes/condition.h"
#include "lib/helm/modes/mode_tree.h"
#include "lib/helm/modes/value_text.h"
#include "lib/mission/file/behavior_update.h"

namespace shoal {
namespace {

/// How long a deployed vehicle, and one to which an event happened, is watched.
constexpr int kWatched_s = 60;
constexpr double kLongestRehearsal_s = 7200;

/// Returns the variable and the value of "PATROL=true"; nothing for other text.
std::optional<ReceivedSetting> SettingOf(std::string_view text) {
  const size_t equals = text.find('=');
  if (equals == text.npos) return std::nullopt;
  return ReceivedSetting{.variable = std::string(Trimmed(text.substr(0, equals))),
                         .value = ValueIn(Trimmed(text.substr(equals + 1))),
                         .source = "event"};
}

class Rehearsal {
 public:
  Rehearsal(const Mission& mission, const Vehicle& vehicle)
      : mission_(mission),
        vehicle_(vehicle),
        set_({.vehicle = vehicle.name,
              .behaviors = vehicle.behaviors,
              .modes = vehicle.modes,
              .variables = vehicle.variables,
              .domain = vehicle.domain,
              .goals_mandatory = vehicle.helm_options.goals_mandatory,
              .read_update = ReadBehaviorUpdate}) {
    for (const Vehicle& other : mission.vehicles) {
      if (other.name == vehicle.name || !mission.IsReported(other)) continue;
      contacts_[other.name] = {.name = other.name, .now = MotionOf(other)};
    }
  }

  VehicleOutlook Run() {
    Order("deploy");
    size_t next = 0;
    double until_s = kWatched_s;
    for (const Event& event : mission_.events) until_s = event.at_s + kWatched_s;
    until_s = std::min(until_s, kLongestRehearsal_s);
    for (int t_s = 0; t_s <= until_s; ++t_s) {
      for (; next < mission_.events.size() && mission_.events[next].at_s <= t_s; ++next) {
        Take(mission_.events[next]);
      }
      const HelmOutcome outcome = Iterate(t_s);
      if (outcome.commands.speed_mps.value_or(0) > 0) return Moves(outcome, t_s);
    }
    return {.vehicle = vehicle_.name, .moves = false, .why = WhyItStays()};
  }

 private:
  static VesselMotion MotionOf(const Vehicle& vehicle) {
    return {.position_m = {vehicle.start.x_m, vehicle.start.y_m},
            .heading_deg = vehicle.start.heading_deg,
            .speed_mps = vehicle.start.speed_mps};
  }

  void Set(const char* name, const char* value) {
    if (set_.variables().Find(name) == nullptr) return;
    settings_.push_back({.variable = name, .value = std::string(value), .source = "order"});
  }

  /// As the helm takes orders where variables stand for them (apps/helm/arbiter.cc).
  void Order(std::string_view command) {
    const auto& keeps = vehicle_.helm_options.deploy_keeps;
    const auto is_kept = [&](const char* name) {
      return command == "deploy" && std::find(keeps.begin(), keeps.end(), name) != keeps.end();
    };
    if (command == "station_keep") return Set("STATION_KEEP", "true");
    Set("DEPLOY", "true");
    if (!is_kept("RETURN")) Set("RETURN", command == "return" ? "true" : "false");
    if (!is_kept("STATION_KEEP")) Set("STATION_KEEP", "false");
  }

  void Take(const Event& event) {
    const auto* command = std::get_if<CommandEvent>(&event.what);
    if (command == nullptr) return;
    const auto addressed = mission_.VehiclesNamed(command->vehicle);
    if (std::find(addressed.begin(), addressed.end(), &vehicle_) == addressed.end()) return;
    if (command->command == "set") {
      if (auto setting = SettingOf(command->argument)) settings_.push_back(std::move(*setting));
    } else if (command->command == "deploy" || command->command == "return" ||
               command->command == "station_keep") {
      Order(command->command);
    }
  }

  HelmOutcome Iterate(int t_s) {
    return set_.Iterate({.time_s = static_cast<double>(t_s),
                         .drives = true,
                         .own = OwnMotion{.motion = MotionOf(vehicle_)},
                         .contacts = &contacts_,
                         .obstacles = &mission_.obstacles,
                         .settings = std::exchange(settings_, {}),
                         .explains = false});
  }

  VehicleOutlook Moves(const HelmOutcome& outcome, int t_s) const {
    std::string names;
    for (const HelmAim& aim : outcome.aims) {
      if (aim.is_constraint || aim.name == "deploy_button") continue;  // Moves nothing.
      names += (names.empty() ? "" : ", ") + aim.name;
    }
    if (t_s > kWatched_s) names += fmt::format(", from {} s on", t_s);
    return {.vehicle = vehicle_.name, .moves = true, .why = names};
  }

  std::string WhyItStays() const {
    constexpr size_t kMostShown = 5;
    std::vector<std::string> reasons;
    for (const BehaviorOptions& behavior : vehicle_.behaviors) {
      if (behavior.name == "deploy_button") continue;  // Moves nothing.
      reasons.push_back(behavior.name + WhyItIsIdle(behavior));
    }
    if (reasons.empty()) return "it has no behaviors";
    const size_t num_more = reasons.size() - std::min(reasons.size(), kMostShown);
    reasons.resize(reasons.size() - num_more);
    std::string text = fmt::format("{}", fmt::join(reasons, "; "));
    if (num_more > 0) text += fmt::format("; and {} more", num_more);
    return text;
  }

  std::string WhyItIsIdle(const BehaviorOptions& behavior) const {
    if (behavior.templating == Templating::kSpawn) return " is only begun for what comes near";
    for (const std::string& text : ConditionsOf(behavior)) {
      const auto condition = Condition::Parse(text);
      if (condition.ok() && !condition->Holds(set_.variables())) {
        return fmt::format(" waits for {}{}", text, OrderFor(*condition));
      }
    }
    const auto* waypoint = std::get_if<WaypointOptions>(&behavior.what);
    const auto* loiter = std::get_if<LoiterOptions>(&behavior.what);
    const bool has_no_points = (waypoint != nullptr && waypoint->points.empty()) ||
                               (loiter != nullptr && loiter->polygon.empty());
    if (has_no_points) {
      return behavior.updates.empty() ? " has no points"
                                      : " waits for points by " + behavior.updates;
    }
    return " gives no speed";
  }

  /// Returns the order of the mission that sets a variable of the condition.
  std::string OrderFor(const Condition& condition) const {
    for (const std::string& variable : condition.VariablesUsed()) {
      for (const NamedOrder& order : mission_.orders) {
        if (order.command.argument.starts_with(variable + "=")) {
          return fmt::format(" (shoal send {})", order.name);
        }
      }
    }
    return {};
  }

  const Mission& mission_;
  const Vehicle& vehicle_;
  BehaviorSet set_;
  Contacts contacts_;
  std::vector<ReceivedSetting> settings_;
};

}  // namespace

std::vector<VehicleOutlook> OutlooksOf(const Mission& mission) {
  std::vector<VehicleOutlook> outlooks;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (!vehicle.tasks.empty()) {
      outlooks.push_back({.vehicle = vehicle.name, .moves = true, .why = "its tasks"});
    } else {
      outlooks.push_back(Rehearsal(mission, vehicle).Run());
    }
  }
  return outlooks;
}

}  // namespace shoal
