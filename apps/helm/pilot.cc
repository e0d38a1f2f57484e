#include "apps/helm/pilot.h"

#include "apps/helm/surface_pilot.h"
#include "apps/helm/underwater_pilot.h"

namespace shoal {

std::unique_ptr<Pilot> MakePilot(const Vehicle& vehicle) {
  if (vehicle.model == "remus100") return std::make_unique<UnderwaterPilot>(vehicle.remus100);
  return std::make_unique<SurfacePilot>(vehicle);
}

}  // namespace shoal
