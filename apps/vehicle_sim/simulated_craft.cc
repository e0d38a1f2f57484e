#include "apps/vehicle_sim/simulated_craft.h"

#include <variant>

#include "apps/vehicle_sim/simulated_buoy.h"
#include "apps/vehicle_sim/simulated_remus100.h"
#include "apps/vehicle_sim/simulated_surface_craft.h"
#include "apps/vehicle_sim/simulated_track.h"
#include "lib/base/check/check.h"

namespace shoal {

namespace {

/// One line for each model of AnyModel.
struct CraftOfModel {
  const Mission& mission;

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
  Craft operator()(const TrackOptions& options) const {
    Result<MissionTrack> track = TrackOf(mission, options);
    SHOAL_CHECK(track.ok(), "the mission file was checked, and its track could be read");
    return std::make_unique<SimulatedTrack>(std::move(*track));
  }
};

}  // namespace

std::unique_ptr<SimulatedCraft> MakeSimulatedCraft(const Mission& mission, const Vehicle& vehicle) {
  return std::visit(CraftOfModel{mission}, vehicle.model);
}

}  // namespace shoal
