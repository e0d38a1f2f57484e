// Eigenrays where nothing depends on the range. FindEigenrays calls it; see eigenrays.h.
//
// By Snell's law p = cos(angle) / c is the same all along a ray, and so each layer with a linear
// profile adds closed forms to range, time and length (for example Jensen, Kuperman, Porter,
// Schmidt, Computational Ocean Acoustics, 2nd ed., ch. 3). All paths of one p are made of three
// parts: up from the shallower end, between the ends, down from the deeper one.
#pragma once

#include <vector>

#include "lib/sea/rays/eigenrays.h"

namespace shoal {

/// The arrivals, in no particular order. @pre as FindEigenrays; IsLayered(scene); both ends in the
/// water; receiver.range_m > source.range_m
[[nodiscard]] std::vector<RayArrival> FindLayeredRays(const RayScene& scene,
                                                      const SectionPoint& source,
                                                      const SectionPoint& receiver,
                                                      const RayLimits& limits);

}  // namespace shoal
