// What only underwater vehicles can do, and whether those that follow each other can.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <variant>

#include "lib/mission/file/validate.h"
#include "lib/vehicle/guidance/turning_room.h"

namespace shoal {
namespace {

bool NeedsSonar(const VelocityCascade& cascade) {
  return std::any_of(cascade.layers.begin(), cascade.layers.end(),
                     [](const VelocityLayer& layer) { return SonarOf(layer) != nullptr; });
}

/// Returns "model = "remus100"" for messages: every model that dives.
std::string UnderwaterModels() {
  std::string text;
  for (const AnyModel& model : EachModel()) {
    const ModelFacts facts = FactsOfModel(model);
    if (!facts.is_underwater) continue;
    text += fmt::format("{}\"{}\"", text.empty() ? "model = " : " or ", facts.name);
  }
  return text;
}

void CheckModel(const TablePlace& place, const Vehicle& vehicle, int64_t tick_us) {
  const ModelFacts facts = FactsOfModel(vehicle.model);
  if (facts.longest_tick_s > 0 && static_cast<double>(tick_us) > facts.longest_tick_s * 1e6) {
    place.Refuse("model", fmt::format("a {} must be steered every {:g} s or faster: write tick_s = "
                                      "0.1 in [mission]",
                                      facts.name, facts.longest_tick_s));
  }
  if (!facts.is_underwater && vehicle.start.depth_m > 0) {
    place.Refuse("start",
                 fmt::format("only a vehicle of {} can start under water", UnderwaterModels()));
  }
}

/// What a vehicle needs to know the floor in the way that it is to.
void CheckFloorSource(const TablePlace& place, const Vehicle& vehicle, const Mission& mission) {
  const auto* model = std::get_if<Remus100Options>(&vehicle.model);
  if (model == nullptr) return;
  if (model->floor_from == "chart" && mission.environment.floor.style == "none") {
    place.Below("remus100")
        .Refuse("floor_from",
                "floor_from = \"chart\" needs a sea floor: write floor = {style = \"linear\"} in "
                "[environment], or floor_from = \"altimeter\"");
  }
  if (model->floor_from == "sonar" && !vehicle.sonar.is_fitted) {
    place.Below("remus100")
        .Refuse("floor_from",
                "floor_from = \"sonar\" needs one: write [vehicle.sonar] under "
                "the [[vehicle]], or floor_from = \"altimeter\"");
  }
}

/// What a task with swarm = "acoustic" needs of [swarm].
void CheckAcousticTask(const TablePlace& place, const TargetTrackTask& track,
                       const Vehicle& vehicle, const Mission& mission) {
  if (track.swarm != SwarmKnowledge::kAcoustic) return;
  const SwarmOptions* own = mission.SwarmOf(vehicle);
  const SwarmOptions* swarm = own;
  if (swarm == nullptr && !mission.swarms.empty()) {
    const auto led = std::ranges::find(mission.swarms, track.target, &SwarmOptions::leader);
    swarm = led == mission.swarms.end() ? &mission.swarms.front() : &*led;
  }
  if (swarm == nullptr) {
    place.Refuse("swarm", fmt::format("swarm = \"acoustic\" needs an acoustic swarm: write "
                                      "[swarm] and leader = \"{}\", or swarm = \"direct\"",
                                      track.target));
  } else if (swarm->leader.empty()) {
    return;  // That is refused in [swarm].
  } else if (track.target != swarm->leader) {
    place.Refuse("target", fmt::format("only the leader of [swarm], {}, reports its position "
                                       "to followers over the acoustic network",
                                       swarm->leader));
  } else if (own == nullptr) {
    place.Refuse("swarm", fmt::format("{} is not among the followers of [swarm]: add it, or leave "
                                      "followers out",
                                      vehicle.name));
  }
}

/// What a vehicle does when its tasks are done must be something that it can.
void CheckEnding(const TablePlace& place, const Vehicle& vehicle) {
  const ModelFacts facts = FactsOfModel(vehicle.model);
  const HelmOptions& options = vehicle.helm_options;
  const TablePlace table = place.Below("helm_options");
  if (options.end_of_tasks == Ending::kSurface && !facts.is_underwater) {
    table.Refuse("end_of_tasks",
                 fmt::format("only a vehicle of {} comes up: write end_of_tasks = \"hold\"",
                             UnderwaterModels()));
  }
  if (table.Has("hold_radius_m") && options.hold_radius_m < facts.turning_diameter_m) {
    table.Warn("hold_radius_m",
               fmt::format("hold_radius_m = {:g} is less than the {:g} m in which the vehicle "
                           "turns: it will circle",
                           options.hold_radius_m, facts.turning_diameter_m));
  }
  if (options.end_of_tasks != Ending::kEndMission) return;
  for (size_t k = 0; k < vehicle.tasks.size(); ++k) {
    if (vehicle.tasks[k].name != kEndOfTasks) continue;
    place.Below("task", k).Refuse("name",
                                  "end_of_tasks = \"end_mission\" needs this name: give "
                                  "the task another");
  }
}

void CheckSonar(const TablePlace& place, const VelocityCascade& cascade, const Vehicle& vehicle) {
  if (!NeedsSonar(cascade) || vehicle.sonar.is_fitted) return;
  place.Refuse("layers",
               "the layers that keep away from what a sonar sees need one: write "
               "[vehicle.sonar] under the [[vehicle]]");
}

void CheckPathFollowing(const TablePlace& place, const PathFollowTask& path, const Vehicle& vehicle,
                        const Mission& mission) {
  CheckSonar(place, path.cascade, vehicle);
  if (path.swarm == SwarmKnowledge::kAcoustic && mission.SwarmOf(vehicle) == nullptr) {
    place.Refuse("swarm", fmt::format("swarm = \"acoustic\" is for members of [swarm], and {} is "
                                      "none: name it there, or write swarm = \"direct\"",
                                      vehicle.name));
  }
}

/// How far it turns between obstacles is known of a rudder that may be used as far as usual.
void WarnOfWideTurns(const TablePlace& place, const Task& task, const Vehicle& vehicle) {
  const auto& track = std::get<TargetTrackTask>(task.what);
  const auto* cascade = std::get_if<VelocityCascade>(&track.track.law);
  const auto* model = std::get_if<Remus100Options>(&vehicle.model);
  if (cascade == nullptr || model == nullptr) return;
  const double most_deg = GainsOf(*model).max_fin_deg;
  if (!track.speed_along_bow || !NeedsSonar(*cascade) || most_deg >= kTurningRudder_deg) return;
  place.Below("autopilot")
      .Warn("max_fin_deg",
            fmt::format("with {:g} degrees of rudder it turns on a wider circle than the task {} "
                        "leaves room for before obstacles: write {:g} or more, or keep its leader "
                        "far from them",
                        most_deg, Quoted(task.name), kTurningRudder_deg));
}

void CheckTargetTracking(const TablePlace& place, const TargetTrackTask& track,
                         const Vehicle& vehicle, const Mission& mission) {
  if (const auto* cascade = std::get_if<VelocityCascade>(&track.track.law)) {
    CheckSonar(place, *cascade, vehicle);
  }
  if (track.target == vehicle.name) place.Refuse("target", "a vehicle cannot follow itself");
  CheckAcousticTask(place, track, vehicle, mission);
}

}  // namespace

void ValidateUnderwater(const Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    const TablePlace place = file.Below("vehicle", i);
    CheckModel(place, vehicle, mission.tick_us);
    CheckEnding(place, vehicle);
    CheckFloorSource(place, vehicle, mission);
    for (size_t k = 0; k < vehicle.tasks.size(); ++k) {
      const Task& task = vehicle.tasks[k];
      if (FactsOf(task).is_underwater && !FactsOfModel(vehicle.model).is_underwater) {
        place.Below("task", k).Refuse(
            "kind", fmt::format("{} is a task of underwater vehicles: write {} in the [[vehicle]], "
                                "or kind = \"waypoints\"",
                                KindOf(task), UnderwaterModels()));
      }
      if (const auto* track = std::get_if<TargetTrackTask>(&task.what)) {
        CheckTargetTracking(place.Below("task", k), *track, vehicle, mission);
        WarnOfWideTurns(place, task, vehicle);
      }
      if (const auto* path = std::get_if<PathFollowTask>(&task.what)) {
        CheckPathFollowing(place.Below("task", k), *path, vehicle, mission);
      }
    }
  }
}

}  // namespace shoal
