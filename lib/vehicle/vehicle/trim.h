// How a Remus 100 lies in the water, and how steeply its fins can hold it.
//
//   const double z_m = FloatingDepth(auv);
//   const double climb_mps = speed_mps * Sin(SteepestPitch(auv, speed_mps));
#pragma once

#include "lib/vehicle/vehicle/remus100_params.h"

namespace shoal {

/// Returns the least depth of the axis at which a level hull's buoyancy carries its weight; where
/// it never does, that at which the hull is just under water. 0 for the sets that have a surface of
/// another kind.
[[nodiscard]] double FloatingDepth(const Remus100& auv);

/// Returns the pitch, [0, pi / 2], at which the stern planes at their limit just balance the
/// restoring moment: sin(pitch) = arm x lift / (weight x cg_below_axis). @pre speed_mps finite
[[nodiscard]] double SteepestPitch(const Remus100& auv, double speed_mps);

}  // namespace shoal
