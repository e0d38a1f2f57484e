// Weighs layers of velocity guidance by priority: the saturation cascade after the subsumption
// architecture. The speed u_max is a budget; each layer spends a share of what those above it left.
//
//   VelocityCascade law;   // survival, formation, feed forward
//   Eigen::Vector3d v_d_mps = DesiredVelocity(law, 2.5, surroundings);
//
//   s_i = min(|v_i| / u_max, 1)     w_0 = 1     w_(i+1) = w_i (1 - s_i)     v = sum w_i v_i
//
// and v no longer than u_max. Brooks (1986), IEEE J. Robotics and Automation 2(1):14-23 (priority);
// Arkin (1989), Int. J. Robotics Research 8(4):92-112 (sum of motor schemas); Antonelli,
// Arrichiello and Chiaverini (2009), IEEE TCST 17(5):1173-1182 (what is above projects out what is
// below).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "lib/guidance/velocity_layers.h"

namespace shoal {

/// The layers of one vehicle, the most urgent first.
struct VelocityCascade {
  std::vector<VelocityLayer> layers = {SurvivalLayer{}, FormationLayer{}, FeedForwardLayer{}};

  bool operator==(const VelocityCascade&) const = default;
};

/// Adds up layers' velocities one by one, the most urgent first.
class BudgetSum {
 public:
  /// @pre u_max_mps >= 0; with 0 every layer that wants to move spends all of it
  explicit BudgetSum(double u_max_mps) : u_max_mps_(u_max_mps) {}

  void Add(const Eigen::Vector3d& layer_mps);

  double weight() const { return weight_; }  ///< Of the next layer, in [0, 1].
  Eigen::Vector3d Velocity_mps() const;      ///< Clamped to u_max.

 private:
  double u_max_mps_;
  double weight_ = 1;
  Eigen::Vector3d sum_mps_ = Eigen::Vector3d::Zero();
};

/// Returns what the layers make together, u_max at most.
/// @pre everything finite, u_max_mps >= 0
[[nodiscard]] Eigen::Vector3d DesiredVelocity(const VelocityCascade& cascade, double u_max_mps,
                                              const Surroundings& surroundings);

}  // namespace shoal
