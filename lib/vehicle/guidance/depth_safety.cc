#include "lib/vehicle/guidance/depth_safety.h"

#include <algorithm>

#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

namespace {

// Returns the limited command of a vehicle that is `beyond_m` past a limit; speeds count positive
// toward it.
double Brake(double beyond_m, double z_safe_m, double command_mps, double own_mps) {
  if (beyond_m <= 0 || command_mps + own_mps <= 0) return command_mps;
  const double share = z_safe_m > beyond_m ? beyond_m / z_safe_m : 1;
  return command_mps - share * std::max(command_mps, 0.0) - share * std::max(own_mps, 0.0);
}

}  // namespace

Eigen::Vector3d ApplyDepthSafety(const DepthSafety& limits, double seabed_z_m, double z_m,
                                 double own_vz_mps, const Eigen::Vector3d& command_mps) {
  const double z = Plausible(z_m);
  const double own_mps = Plausible(own_vz_mps);
  Eigen::Vector3d limited_mps = Plausible(command_mps);
  const double below_m = z - (Plausible(std::min(seabed_z_m, limits.z_max_m)) - limits.z_safe_m);
  if (below_m > 0) {
    limited_mps.z() = Brake(below_m, limits.z_safe_m, limited_mps.z(), own_mps);
    const double share = std::min(1.0, below_m / limits.z_safe_m);
    if (limits.climb_mps > 0) {
      limited_mps.z() = std::min(limited_mps.z(), -share * limits.climb_mps);
    }
  } else {
    limited_mps.z() = -Brake(limits.z_min_m - z, limits.z_safe_m, -limited_mps.z(), -own_mps);
  }
  return limited_mps;
}

}  // namespace shoal
