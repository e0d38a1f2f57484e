#include "lib/guidance/velocity_layers.h"

#include <algorithm>

#include "lib/guidance/line_of_sight.h"
#include "lib/guidance/plausible.h"

namespace shoal {

namespace {

double Cube(double x) { return x * x * x; }

}  // namespace

Eigen::Vector3d LayerVelocity(const FeedForwardLayer&, double, const Surroundings& surroundings) {
  if (!surroundings.target) return Eigen::Vector3d::Zero();
  return Plausible(surroundings.target->velocity_mps);
}

Eigen::Vector3d LayerVelocity(const FormationLayer& layer, double u_max_mps,
                              const Surroundings& surroundings) {
  if (!surroundings.target) return Eigen::Vector3d::Zero();
  const LineOfSight sight = SightFrom(*surroundings.target, surroundings.own);
  const double r_m = sight.range_m;
  if (r_m <= layer.r_safe_m) return u_max_mps * sight.away;
  if (r_m < layer.r_inner_m) {
    const double x = (layer.r_inner_m - r_m) / (layer.r_inner_m - layer.r_safe_m);
    return u_max_mps * Cube(x) * sight.away;
  }
  const double r_outer_m = layer.r_outer_m();
  if (r_m <= r_outer_m) return Eigen::Vector3d::Zero();
  if (r_m < layer.r_max_m()) {
    const double x = (r_m - r_outer_m) / (layer.r_max_m() - r_outer_m);
    return -u_max_mps * Cube(x) * sight.away;
  }
  return -u_max_mps * sight.away;
}

Eigen::Vector3d LayerVelocity(const SurvivalGroupLayer& layer, double u_max_mps,
                              const Surroundings& surroundings) {
  Eigen::Vector3d sum_mps = Eigen::Vector3d::Zero();
  for (const Neighbour& member : surroundings.group) {
    const LineOfSight sight = SightFrom(member, surroundings.own);
    if (sight.range_m <= layer.r_safe_m) {
      sum_mps += u_max_mps * sight.away;
    } else if (sight.range_m < layer.r_avoid_m) {
      const double x = (layer.r_avoid_m - sight.range_m) / (layer.r_avoid_m - layer.r_safe_m);
      sum_mps += u_max_mps * Cube(x) * sight.away;
    }
  }
  return ClampNorm(sum_mps, u_max_mps);
}

Eigen::Vector3d LayerVelocity(const SurvivalSonarLayer& layer, double u_max_mps,
                              const Surroundings& surroundings) {
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
  double sum = 0;
  double strongest = 0;
  for (const SonarEcho& echo : surroundings.sonar) {
    const double range_m = std::max(Plausible(echo.range_m), 0.0);
    if (range_m >= layer.r_avoid_m) continue;
    const double weight = Cube((layer.r_avoid_m - range_m) / layer.r_avoid_m);
    weighted += weight * Plausible(echo.direction);
    sum += weight;
    strongest = std::max(strongest, weight);
  }
  if (sum <= 0) return Eigen::Vector3d::Zero();
  return ClampNorm(-u_max_mps * (strongest / sum) * weighted, u_max_mps);
}

Eigen::Vector3d LayerVelocity(const SurvivalLayer& layer, double u_max_mps,
                              const Surroundings& surroundings) {
  return ClampNorm(LayerVelocity(layer.group, u_max_mps, surroundings) +
                       LayerVelocity(layer.sonar, u_max_mps, surroundings),
                   u_max_mps);
}

}  // namespace shoal
