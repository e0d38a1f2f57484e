#include "apps/helm/pilot.h"

#include <variant>

#include "apps/helm/moored_pilot.h"
#include "apps/helm/surface_pilot.h"
#include "apps/helm/underwater_pilot.h"

namespace shoal {

namespace {

/// One line for each model of AnyModel.
struct PilotOfModel {
  const Vehicle& vehicle;

  std::unique_ptr<Pilot> operator()(const SurfaceCraftParams& craft) const {
    return std::make_unique<SurfacePilot>(craft, vehicle.autopilot);
  }
  std::unique_ptr<Pilot> operator()(const Remus100Options& options) const {
    return std::make_unique<UnderwaterPilot>(options);
  }
  std::unique_ptr<Pilot> operator()(const BuoyParams& /*params*/) const {
    return std::make_unique<MooredPilot>();
  }
};

}  // namespace

std::unique_ptr<Pilot> MakePilot(const Vehicle& vehicle) {
  return std::visit(PilotOfModel{vehicle}, vehicle.model);
}

}  // namespace shoal
