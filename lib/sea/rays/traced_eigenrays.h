// Eigenrays in a section of any kind, by a launch fan that is refined. FindEigenrays calls it; see
// eigenrays.h.
#pragma once

#include <vector>

#include "lib/sea/rays/eigenrays.h"

namespace shoal {

/// The arrivals, in no particular order. @pre as FindEigenrays; both ends in the water;
/// receiver.range_m > source.range_m
[[nodiscard]] std::vector<RayArrival> FindTracedRays(const RayScene& scene,
                                                     const SectionPoint& source,
                                                     const SectionPoint& receiver,
                                                     const RayLimits& limits);

}  // namespace shoal
