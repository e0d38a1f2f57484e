#include "lib/vehicle/guidance/constant_bearing.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/vehicle/guidance/line_of_sight.h"
#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

Eigen::Vector3d DesiredVelocity(const ConstantBearingLaw& law, double u_max_mps,
                                const Surroundings& surroundings) {
  if (!surroundings.target) return Eigen::Vector3d::Zero();
  const LineOfSight sight = SightFrom(*surroundings.target, surroundings.own);
  const Eigen::Vector3d v_t_mps = Plausible(surroundings.target->velocity_mps);
  const double gap_m = sight.range_m - law.r_safe_m;
  const Eigen::Vector3d approach = gap_m >= 0 ? Eigen::Vector3d(-sight.away) : sight.away;

  const double along_mps = v_t_mps.dot(approach);
  const double abeam_squared = (v_t_mps - along_mps * approach).squaredNorm();
  const double u_a_mps =
      std::max(0.0, std::sqrt(std::max(0.0, u_max_mps * u_max_mps - abeam_squared)) - along_mps);
  const double kappa_mps = u_a_mps * std::abs(gap_m) / Hypot(law.lookahead_m, gap_m);
  return ClampNorm(v_t_mps + kappa_mps * approach, u_max_mps);
}

}  // namespace shoal
