// Whether an [[expect]] can hold: vehicles and their tasks, the swarm, the sea floor.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/comms/routing/fate.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/model/coverage_area.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

/// Tasks that a helm does without having them from the mission.
constexpr std::array<std::string_view, 4> kOwnTasks = {"return", "station_keep", "goto",
                                                       kEndOfTasks};

/// Refuses a task that one of the vehicles has not. `own` are the helm's, and right as well.
void CheckTask(const TablePlace& place, const std::string& vehicle_name,
               const std::string& task_name, const Mission& mission,
               std::span<const std::string_view> own) {
  if (task_name.empty()) return;
  for (const Vehicle* vehicle : VehiclesNamed(mission, vehicle_name)) {
    std::vector<std::string_view> names;
    for (const Task& task : vehicle->tasks) names.push_back(task.name);
    names.insert(names.end(), own.begin(), own.end());
    if (std::find(names.begin(), names.end(), task_name) != names.end()) continue;
    place.Refuse("task", fmt::format("{} has no task {}{}", vehicle->name, Quoted(task_name),
                                     DidYouMean(task_name, names)));
    return;
  }
}

/// Refuses more laps than the task of one of the vehicles has.
void CheckLaps(const TablePlace& place, const LapsExpectation& laps, const Mission& mission) {
  for (const Vehicle* vehicle : VehiclesNamed(mission, laps.vehicle)) {
    for (const Task& task : vehicle->tasks) {
      const std::optional<int64_t> most = FactsOf(task).most_laps;
      if (task.name != laps.task || !most || laps.at_least <= *most) continue;
      if (*most == 0) {
        place.Refuse("task", fmt::format("{} of {} is a {}, which has no laps", Quoted(task.name),
                                         vehicle->name, KindOf(task)));
      } else {
        place.Refuse("at_least", fmt::format("at_least = {} can never hold: {} of {} ends after "
                                             "{} lap{}",
                                             laps.at_least, Quoted(task.name), vehicle->name, *most,
                                             *most == 1 ? "" : "s"));
      }
      return;
    }
  }
}

/// What each kind needs of the other tables; a kind that is not named here needs nothing.
struct CheckExpectation {
  const Mission& mission;
  const TablePlace& place;

  template <class OfNoOtherTable>
  void operator()(const OfNoOtherTable&) const {}

  /// Refuses numbers of one destination that are not counted: the far ones of a large fleet.
  void operator()(const CommsExpectation& comms) const {
    const int64_t limit = mission.comms.each_fate_up_to;
    const bool are_together = static_cast<int64_t>(mission.vehicles.size()) > limit;
    if (!are_together || comms.to == "all") return;
    const bool has_percentage = comms.at_least_pct.has_value() || comms.at_most_pct.has_value();
    if (comms.cause != CauseText(Cause::kOutOfRange) && !has_percentage) return;
    place.Refuse("to", fmt::format("in a fleet of more than each_fate_up_to = {} vehicles, those "
                                   "that are out of range are counted together: leave to out, or "
                                   "raise [comms] each_fate_up_to",
                                   limit));
  }

  void operator()(const SwarmExpectation& swarm) const {
    if (mission.swarms.empty()) {
      place.Refuse("kind",
                   "outcomes of swarm messages are published only where there is a [swarm]");
      return;
    }
    for (const auto& [key, name] : {std::pair("from", swarm.from), std::pair("to", swarm.to)}) {
      const Vehicle* vehicle = mission.FindVehicle(name);
      if (vehicle != nullptr && mission.SwarmOf(*vehicle) == nullptr) {
        place.Refuse(key, name + " is not in the swarm: this can never hold");
      }
    }
    const Vehicle* from = mission.FindVehicle(swarm.from);
    const Vehicle* to = mission.FindVehicle(swarm.to);
    if (from != nullptr && to != nullptr && mission.SwarmOf(*from) != mission.SwarmOf(*to)) {
      place.Refuse("to", fmt::format("{} and {} are in different swarms: what one receives of the "
                                     "other is not counted",
                                     from->name, to->name));
    }
    if (swarm.from == swarm.to && swarm.from != "all") {
      place.Refuse("to", swarm.to + " does not receive its own messages: this can never hold");
    }
  }

  /// Warns of vehicles that are there before they have left.
  void operator()(const ArrivalExpectation& arrival) const {
    if (arrival.stays) return;
    for (const Vehicle* vehicle : VehiclesNamed(mission, arrival.vehicle)) {
      const Eigen::Vector2d start_m(vehicle->start.x_m, vehicle->start.y_m);
      const Eigen::Vector2d point_m = arrival.point_m.value_or(vehicle->return_task.point_m);
      const double range_m = (start_m - point_m).norm();
      if (vehicle->sim != Provider::kShoal || range_m > arrival.within_m) continue;
      place.Warn("", fmt::format("{} starts {:.1f} m from the point, so this is met before it has "
                                 "left: write stays = true, or another point",
                                 vehicle->name, range_m));
      return;
    }
  }

  void operator()(const HelmExpectation& helm) const {
    CheckTask(place, helm.vehicle, helm.task, mission, kOwnTasks);
  }

  void operator()(const LapsExpectation& laps) const {
    CheckTask(place, laps.vehicle, laps.task, mission, {});
    CheckLaps(place, laps, mission);
  }

  void operator()(const ClosestApproachExpectation& approach) const { CheckPair(approach); }
  void operator()(const EncounterScoreExpectation& score) const { CheckPair(score); }

  template <class OfPairs>
  void CheckPair(const OfPairs& expectation) const {
    if (expectation.to == "all" || expectation.to != expectation.vehicle) return;
    place.Refuse("to", expectation.to + " does not meet itself: this can never hold");
  }

  void operator()(const CoverageExpectation& coverage) const {
    if (!place.IsSound() || !PolygonsOf(mission, coverage).empty()) return;
    place.Refuse("",
                 "there is no area to cover: none of the vehicles has a task of kind "
                 "\"survey\"; write polygon = [[0, 0], [200, 0], [200, 100]]");
  }

  void operator()(const NavigationErrorExpectation& error) const {
    for (const Vehicle* vehicle : VehiclesNamed(mission, error.vehicle)) {
      if (vehicle->navigation.is_fitted) continue;
      place.Refuse("vehicle", fmt::format("{} knows where it is: give it [vehicle.navigation], or "
                                          "name the vehicles that have it",
                                          vehicle->name));
      return;
    }
  }

  void operator()(const AltitudeExpectation&) const {
    if (mission.environment.floor.style != "none") return;
    place.Refuse("",
                 "there is no altitude without a sea floor: write [environment] floor = "
                 "{style = \"flat\", depth_m = 50}");
  }
};

}  // namespace

void ValidateExpectations(const Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.expectations.size(); ++i) {
    std::visit(CheckExpectation{mission, file.Below("expect", i)}, mission.expectations[i].what);
  }
}

}  // namespace shoal
