// Surface craft in mission files: model = "surface_craft" and its table [vehicle.surface_craft].
#pragma once

#include "lib/mission/model/model_facts.h"
#include "lib/vehicle/vehicle/surface_craft.h"

namespace shoal {

class Fields;

constexpr ModelFacts FactsOf(const SurfaceCraftParams& /*model*/) {
  return {.name = "surface_craft"};
}

/// [vehicle.surface_craft].
void Describe(Fields& fields, SurfaceCraftParams& params);

}  // namespace shoal
