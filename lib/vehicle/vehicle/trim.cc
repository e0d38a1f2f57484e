#include "lib/vehicle/vehicle/trim.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/hydrodynamics.h"

namespace shoal {

double FloatingDepth(const Remus100& auv) {
  if (auv.params.variants.surface != Remus100Variants::Surface::kShare) return 0;
  const double diameter_m = auv.params.diameter_m;
  // The share under water grows with the depth: halve the interval.
  double above_m = -diameter_m / 2;
  double below_m = diameter_m / 2;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double z_m = (above_m + below_m) / 2;
    const bool floats =
        auv.submerged.buoyancy_n * SubmergedShare(z_m, diameter_m) >= auv.submerged.weight_n;
    (floats ? below_m : above_m) = z_m;
  }
  return below_m;
}

double SteepestPitch(const Remus100& auv, double speed_mps) {
  const TailFin& fin = auv.params.stern_plane;
  const double lift_n = 0.5 * auv.params.water_density_kgpm3 * speed_mps * speed_mps * fin.area_m2 *
                        fin.lift_coefficient * auv.params.max_fin_rad;
  const double restoring_nm = auv.submerged.weight_n * auv.params.cg_below_axis_m;
  const double moment_nm = std::abs(fin.x_m) * lift_n;
  return moment_nm < restoring_nm ? Asin(moment_nm / restoring_nm) : kPi / 2;
}

}  // namespace shoal
