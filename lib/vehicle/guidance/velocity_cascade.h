// Weighs layers of velocity guidance by priority: the saturation cascade after the subsumption
// architecture. The speed u_max is a budget; each layer spends a share of what those above it left.
//
//   VelocityCascade law;   // survival, formation, feed forward
//   Eigen::Vector3d v_d_mps = DesiredVelocity(law, 2.5, surroundings);
//
//   s_i = min(|v_i| / u_max, 1)   w_0 = alpha   w_1 = 1 - w_0 s_0   w_(i+1) = w_i (1 - s_i), i > 0
//   v = sum w_i v_i
//
// and v no longer than u_max. alpha = 1 is the law; less makes the first layer yield to those
// below. Brooks (1986), IEEE J. Robotics and Automation 2(1):14-23 (priority); Arkin (1989), Int.
// J. Robotics Research 8(4):92-112 (sum of motor schemas); Antonelli, Arrichiello and Chiaverini
// (2009), IEEE TCST 17(5):1173-1182 (what is above projects out what is below).
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "lib/vehicle/guidance/velocity_layers.h"

namespace shoal {

/// The layers of one vehicle, the most urgent first.
struct VelocityCascade {
  std::vector<VelocityLayer> layers = {SurvivalLayer{}, FormationLayer{}, FeedForwardLayer{}};
  double alpha = 1;  ///< Weight of the first layer, in [0, 1].

  bool operator==(const VelocityCascade&) const = default;
};

/// What one layer asks for, and the weight that those above it left.
struct LayerShare {
  std::string_view name;  ///< Of static storage: NameOf, or "waypoint".
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
  double weight = 0;
};

/// Adds up layers' velocities one by one, the most urgent first.
class BudgetSum {
 public:
  /// @pre u_max_mps >= 0; with 0 every layer that wants to move spends all of it
  explicit BudgetSum(double u_max_mps, double alpha = 1) : u_max_mps_(u_max_mps), weight_(alpha) {}

  void Add(const Eigen::Vector3d& layer_mps);

  double weight() const { return weight_; }  ///< Of the next layer, in [0, 1].
  Eigen::Vector3d Velocity_mps() const;      ///< Clamped to u_max.

 private:
  double u_max_mps_;
  double weight_;
  bool is_first_ = true;
  Eigen::Vector3d sum_mps_ = Eigen::Vector3d::Zero();
};

/// Returns what the layers make together, u_max at most; appends their shares to `shares`, unless
/// it is null. @pre everything finite, u_max_mps >= 0
[[nodiscard]] Eigen::Vector3d DesiredVelocity(const VelocityCascade& cascade, double u_max_mps,
                                              const Surroundings& surroundings,
                                              std::vector<LayerShare>* shares = nullptr);

/// Returns the layers together with the way to a waypoint, `way_mps` over ground, as the last and
/// least urgent of them, named "waypoint".
[[nodiscard]] Eigen::Vector3d DesiredVelocityOnWay(const VelocityCascade& cascade, double u_max_mps,
                                                   const Surroundings& surroundings,
                                                   const Eigen::Vector3d& way_mps,
                                                   std::vector<LayerShare>* shares);

}  // namespace shoal
