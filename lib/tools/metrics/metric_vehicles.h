// The vehicles that metrics name.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/tools/metrics/metric.h"
#include "lib/vehicle/guidance/task.h"

namespace shoal {

/// Returns the places in the mission of a vehicle, of "all", or of those of "group:NAME".
[[nodiscard]] std::vector<size_t> PlacesOf(const Mission& mission, std::string_view addressees);

/// Distances to its target that a follower should keep.
struct FollowZone {
  double min_m = 0;
  double max_m = 0;
};

/// Returns the zone of rest of the task's formation layer, or the one distance of its constant
/// bearing law; nothing where its law keeps none.
[[nodiscard]] std::optional<FollowZone> FollowZoneOf(const TargetTrackTask& task);

/// True where an age of information is about contacts of the swarm, false for node reports.
[[nodiscard]] bool IsOfSwarm(const Mission& mission, AgeSource source);

}  // namespace shoal
