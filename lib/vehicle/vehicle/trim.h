// How a Remus 100 lies in the water, and how steeply its fins can hold it.
//
//   const double z_m = FloatingDepth(auv);
//   const double level_rad = PitchOf(LevelTrimOf(auv), speed_mps);
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

/// The pitch at which a hull that is not neutral goes on a level: -1 / (square U^2 + linear U) at
/// speed U, lift against buoyancy. Both 0: it is neutral.
struct LevelTrim {
  double square_s2pm2 = 0;
  double linear_spm = 0;
};

/// Returns that of a vehicle under water, from its model at 1 and 2 m/s.
[[nodiscard]] LevelTrim LevelTrimOf(const Remus100& auv);

/// Returns the pitch, bow up; that of 1 m/s where it is slower. @pre speed_mps finite
[[nodiscard]] double PitchOf(const LevelTrim& trim, double speed_mps);

}  // namespace shoal
