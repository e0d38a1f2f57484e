// Writes what /api/vehicle and /api/trails answer.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/tools/view/scene.h"
#include "lib/tools/view/trail.h"
#include "lib/tools/view/vehicle_history.h"

namespace shoal {

/// Returns the vehicle's charts, its swarm's knowledge and the vehicles that it has received,
/// at the scene's time.
[[nodiscard]] std::string VehicleJson(const Scene& scene, const SceneVehicle& vehicle,
                                      std::span<const ChartPoint> points);

/// Returns the trails of the scene's vehicles, by their place.
[[nodiscard]] std::string TrailsJson(const Scene& scene, std::span<const Trail> trails);
/// The same of vehicles by their names.
[[nodiscard]] std::string TrailsJson(const std::vector<std::string>& names,
                                     std::span<const Trail> trails);

}  // namespace shoal
