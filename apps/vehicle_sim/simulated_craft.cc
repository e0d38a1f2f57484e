#include "apps/vehicle_sim/simulated_craft.h"

#include "apps/vehicle_sim/simulated_remus100.h"
#include "apps/vehicle_sim/simulated_surface_craft.h"

namespace shoal {

std::unique_ptr<SimulatedCraft> MakeSimulatedCraft(const Vehicle& vehicle) {
  if (vehicle.model == "remus100") return std::make_unique<SimulatedRemus100>(vehicle.remus100);
  return std::make_unique<SimulatedSurfaceCraft>(vehicle.surface_craft);
}

}  // namespace shoal
