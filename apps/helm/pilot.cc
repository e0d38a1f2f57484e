#include "apps/helm/pilot.h"

#include <optional>
#include <variant>

#include "apps/helm/passive_pilot.h"
#include "apps/helm/surface_pilot.h"
#include "apps/helm/underwater_pilot.h"
#include "lib/base/check/check.h"
#include "lib/mission/file/ocean_of.h"

namespace shoal {

namespace {

/// Returns the floor that a vehicle with a chart knows.
std::optional<SeaFloor> ChartFor(const Remus100Options& options, const Mission& mission) {
  if (options.floor_from != "chart") return std::nullopt;
  const Result<Ocean> ocean = OceanOf(mission);
  SHOAL_CHECK(ocean.ok(), "the mission file was checked, and its grid could be read");
  return ocean->floor;
}

/// One line for each model of AnyModel.
struct PilotOfModel {
  const Mission& mission;
  const Vehicle& vehicle;

  std::unique_ptr<Pilot> operator()(const SurfaceCraftParams& craft) const {
    return std::make_unique<SurfacePilot>(craft, vehicle.autopilot);
  }
  std::unique_ptr<Pilot> operator()(const Remus100Options& options) const {
    return std::make_unique<UnderwaterPilot>(options, vehicle.sonar, ChartFor(options, mission));
  }
  std::unique_ptr<Pilot> operator()(const BuoyParams& /*params*/) const {
    return std::make_unique<PassivePilot>("moored");
  }
  std::unique_ptr<Pilot> operator()(const TrackOptions& /*options*/) const {
    return std::make_unique<PassivePilot>("replayed");
  }
};

}  // namespace

std::unique_ptr<Pilot> MakePilot(const Mission& mission, const Vehicle& vehicle) {
  return std::visit(PilotOfModel{mission, vehicle}, vehicle.model);
}

}  // namespace shoal
