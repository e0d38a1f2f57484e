#include "lib/guidance/velocity_cascade.h"

#include <algorithm>

#include "lib/guidance/plausible.h"

namespace shoal {

void BudgetSum::Add(const Eigen::Vector3d& layer_mps) {
  const double speed_mps = layer_mps.norm();
  sum_mps_ += weight_ * layer_mps;
  weight_ *= speed_mps < u_max_mps_ ? 1 - speed_mps / u_max_mps_ : (speed_mps > 0 ? 0.0 : 1.0);
}

Eigen::Vector3d BudgetSum::Velocity_mps() const { return ClampNorm(sum_mps_, u_max_mps_); }

Eigen::Vector3d DesiredVelocity(const VelocityCascade& cascade, double u_max_mps,
                                const Surroundings& surroundings) {
  BudgetSum sum(u_max_mps);
  for (const VelocityLayer& layer : cascade.layers) {
    sum.Add(std::visit(
        [&](const auto& which) { return LayerVelocity(which, u_max_mps, surroundings); }, layer));
  }
  return sum.Velocity_mps();
}

}  // namespace shoal
