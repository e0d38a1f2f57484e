#include "lib/tools/metrics/metric_vehicles.h"

#include <variant>

namespace shoal {

std::vector<size_t> PlacesOf(const Mission& mission, std::string_view addressees) {
  std::vector<size_t> places;
  for (const Vehicle* vehicle : mission.VehiclesNamed(addressees)) {
    places.push_back(static_cast<size_t>(vehicle - mission.vehicles.data()));
  }
  return places;
}

std::optional<FollowZone> FollowZoneOf(const TargetTrackTask& task) {
  if (const auto* bearing = std::get_if<ConstantBearingLaw>(&task.track.law)) {
    return FollowZone{.min_m = bearing->r_safe_m, .max_m = bearing->r_safe_m};
  }
  for (const VelocityLayer& layer : std::get<VelocityCascade>(task.track.law).layers) {
    const auto* formation = std::get_if<FormationLayer>(&layer);
    if (formation == nullptr) continue;
    return FollowZone{.min_m = formation->r_inner_m, .max_m = formation->r_outer_m()};
  }
  return std::nullopt;
}

bool IsOfSwarm(const Mission& mission, AgeSource source) {
  return source == AgeSource::kSwarm || (source == AgeSource::kAuto && !mission.swarms.empty());
}

}  // namespace shoal
