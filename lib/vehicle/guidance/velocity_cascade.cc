#include "lib/vehicle/guidance/velocity_cascade.h"

#include <algorithm>

#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

namespace {

void AddLayers(const VelocityCascade& cascade, double u_max_mps, const Surroundings& surroundings,
               BudgetSum* sum, std::vector<LayerShare>* shares) {
  for (const VelocityLayer& layer : cascade.layers) {
    const Eigen::Vector3d velocity_mps = std::visit(
        [&](const auto& which) { return LayerVelocity(which, u_max_mps, surroundings); }, layer);
    if (shares != nullptr) shares->push_back({NameOf(layer), velocity_mps, sum->weight()});
    sum->Add(velocity_mps);
  }
}

}  // namespace

void BudgetSum::Add(const Eigen::Vector3d& layer_mps) {
  const double speed_mps = layer_mps.norm();
  const double share =
      speed_mps < u_max_mps_ ? speed_mps / u_max_mps_ : (speed_mps > 0 ? 1.0 : 0.0);
  sum_mps_ += weight_ * layer_mps;
  weight_ = is_first_ ? 1 - weight_ * share : weight_ * (1 - share);
  is_first_ = false;
}

Eigen::Vector3d BudgetSum::Velocity_mps() const { return ClampNorm(sum_mps_, u_max_mps_); }

Eigen::Vector3d DesiredVelocity(const VelocityCascade& cascade, double u_max_mps,
                                const Surroundings& surroundings, std::vector<LayerShare>* shares) {
  BudgetSum sum(u_max_mps, cascade.alpha);
  AddLayers(cascade, u_max_mps, surroundings, &sum, shares);
  return sum.Velocity_mps();
}

Eigen::Vector3d DesiredVelocityOnWay(const VelocityCascade& cascade, double u_max_mps,
                                     const Surroundings& surroundings,
                                     const Eigen::Vector3d& way_mps,
                                     std::vector<LayerShare>* shares) {
  BudgetSum sum(u_max_mps, cascade.alpha);
  AddLayers(cascade, u_max_mps, surroundings, &sum, shares);
  shares->push_back({"waypoint", way_mps, sum.weight()});
  sum.Add(way_mps);
  return sum.Velocity_mps();
}

}  // namespace shoal
