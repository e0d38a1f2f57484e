// Moored buoys in mission files: model = "buoy" and its table [vehicle.buoy].
#pragma once

#include "lib/mission/model/model_facts.h"
#include "lib/vehicle/vehicle/buoy.h"

namespace shoal {

class Fields;

constexpr ModelFacts FactsOf(const BuoyParams& /*model*/) {
  return {.name = "buoy", .passive = "moored"};
}

/// [vehicle.buoy].
void Describe(Fields& fields, BuoyParams& params);

}  // namespace shoal
