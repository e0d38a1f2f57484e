// Warns of keys that are right by themselves and have no effect beside the others.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

#include "lib/mission/file/validate.h"
#include "lib/mission/model/swarm_plan.h"

namespace shoal {
namespace {

template <class... Layers>
bool HasLayer(const VelocityCascade& cascade) {
  return std::any_of(cascade.layers.begin(), cascade.layers.end(), [](const VelocityLayer& layer) {
    return (std::holds_alternative<Layers>(layer) || ...);
  });
}

void WarnOfIdleRadii(const TablePlace& place, const VelocityCascade& cascade) {
  const bool has_group = HasLayer<SurvivalGroupLayer, SurvivalLayer>(cascade);
  const bool has_sonar = HasLayer<SurvivalSonarLayer, SurvivalLayer>(cascade);
  const bool has_formation = HasLayer<FormationLayer>(cascade);
  struct Row {
    std::string_view key;
    bool is_used;
    std::string_view layer;
  };
  const std::array<Row, 5> rows = {{{"r_safe_m", has_group || has_formation, "survival"},
                                    {"r_avoid_m", has_group, "survival"},
                                    {"r_sonar_m", has_sonar, "sonar"},
                                    {"r_inner_m", has_formation, "formation"},
                                    {"r_follow_m", has_formation, "formation"}}};
  for (const Row& row : rows) {
    if (row.is_used || !place.Has(row.key)) continue;
    place.Warn(row.key, fmt::format("{} has no effect without its layer: add \"{}\" to layers, or "
                                    "leave it out",
                                    row.key, row.layer));
  }
}

void WarnOfIdleTrackKeys(const TablePlace& place, const TargetTrackTask& track) {
  if (track.swarm == SwarmKnowledge::kDirect && place.Has("on_silence")) {
    place.Warn("on_silence",
               "on_silence has no effect with swarm = \"direct\", which knows all positions at any "
               "time: write swarm = \"acoustic\", or leave it out");
  }
  if (const auto* cascade = std::get_if<VelocityCascade>(&track.track.law)) {
    WarnOfIdleRadii(place, *cascade);
  }
}

/// Lengths of slots that the scheduler does not have.
void WarnOfIdleSlots(const Mission& mission, const SwarmOptions& swarm, const TablePlace& place) {
  const bool asks = SwarmSchemeOf(mission, swarm) == SwarmScheme::kTdmaLf;
  struct Row {
    std::string_view key;
    double length_s;
    bool is_used;
  };
  const std::array<Row, 3> rows = {{{"offset_s", swarm.offset_s, !asks},
                                    {"broadcast_s", swarm.broadcast_s, asks},
                                    {"response_s", swarm.response_s, asks}}};
  for (const Row& row : rows) {
    if (row.is_used || row.length_s < 0) continue;
    place.Warn(row.key,
               fmt::format("{} has no effect here: {}; leave it out", row.key,
                           asks ? "with tdma_lf the leader's request gives each follower its slot"
                                : "only with scheduler = \"tdma_lf\" a leader asks and followers "
                                  "answer"));
  }
}

/// `draught_m` and `grounding`, which need a vehicle at the surface and a floor.
void WarnOfIdleGround(const Mission& mission, const TablePlace& file) {
  const bool has_floor = mission.environment.floor.style != "none";
  if (!has_floor && file.Below("mission").Has("grounding")) {
    file.Below("mission").Warn("grounding",
                               "grounding has no effect, as the mission has no sea floor: write "
                               "[environment] floor, or leave it out");
  }
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const TablePlace place = file.Below("vehicle", i);
    if (!place.Has("draught_m")) continue;
    const Vehicle& vehicle = mission.vehicles[i];
    const bool is_afloat = DraughtOf(vehicle) > 0 && FactsOfModel(vehicle.model).passive.empty();
    if (is_afloat && has_floor) continue;
    place.Warn("draught_m",
               fmt::format("draught_m has no effect, as {}: leave it out",
                           is_afloat ? std::string("the mission has no sea floor")
                                     : vehicle.name + " is not a vessel at the surface"));
  }
}

}  // namespace

void WarnOfIdleKeys(const Mission& mission, const TablePlace& file) {
  WarnOfIdleGround(mission, file);
  for (size_t i = 0; i < mission.swarms.size(); ++i) {
    const TablePlace place = TableOfSwarm(mission, file, i);
    if (place.IsSound()) WarnOfIdleSlots(mission, mission.swarms[i], place);
  }
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    const TablePlace place = file.Below("vehicle", i);
    if (place.Has("recovery") && mission.SwarmOf(vehicle) == nullptr) {
      place.Below("recovery")
          .Warn("",
                fmt::format("[vehicle.recovery] has no effect, as {} is not in an acoustic swarm: "
                            "write [swarm] and name it there, or leave the table out",
                            vehicle.name));
    }
    for (size_t k = 0; k < vehicle.tasks.size(); ++k) {
      if (const auto* track = std::get_if<TargetTrackTask>(&vehicle.tasks[k].what)) {
        WarnOfIdleTrackKeys(place.Below("task", k), *track);
      }
    }
  }
}

}  // namespace shoal
