#include "apps/vehicle_sim/simulated_craft.h"

#include <variant>

#include "apps/vehicle_sim/simulated_buoy.h"
#include "apps/vehicle_sim/simulated_remus100.h"
#include "apps/vehicle_sim/simulated_surface_craft.h"

namespace shoal {

namespace {

/// One line for each model of AnyModel.
struct CraftOfModel {
  using Craft = std::unique_ptr<SimulatedCraft>;
  Craft operator()(const SurfaceCraftParams& params) const {
    return std::make_unique<SimulatedSurfaceCraft>(params);
  }
  Craft operator()(const Remus100Options& options) const {
    return std::make_unique<SimulatedRemus100>(options);
  }
  Craft operator()(const BuoyParams& params) const {
    return std::make_unique<SimulatedBuoy>(params);
  }
};

}  // namespace

std::unique_ptr<SimulatedCraft> MakeSimulatedCraft(const Vehicle& vehicle) {
  return std::visit(CraftOfModel(), vehicle.model);
}

}  // namespace shoal
