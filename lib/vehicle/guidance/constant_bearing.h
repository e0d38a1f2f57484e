// Constant bearing: approaches a target on parallel navigation, down to a safe distance.
#pragma once

#include <Eigen/Core>

#include "lib/vehicle/guidance/surroundings.h"

namespace shoal {

struct ConstantBearingLaw {
  double lookahead_m = 50;  ///< Delta: within about this distance the approach slows down; > 0.
  double r_safe_m = 10;     ///< Distance to keep; >= 0.

  bool operator==(const ConstantBearingLaw&) const = default;
};

/// Returns the velocity (world axes) that follows the target:
///
///   los   = (p - p_t) / |p - p_t|        p_los = (p - p_t) - r_safe los
///   v_d   = v_t - Kappa p_los / |p_los|
///   Kappa = U_a |p_los| / sqrt(Delta^2 + |p_los|^2)
///
/// with U_a >= 0 such that |v_t - U_a p_los / |p_los|| = u_max: the velocity triangle. Inside
/// r_safe p_los points to the target, and the vehicle moves away from it. A target faster than
/// u_max may leave no such U_a; then the nearest to one. The result is never longer than u_max.
/// Breivik, Hovstein and Fossen (2008), "Straight-Line Target Tracking for Unmanned Surface
/// Vehicles", Modeling, Identification and Control 29(4):131-149; Fossen (2021), Handbook of Marine
/// Craft Hydrodynamics and Motion Control, 2nd edition, chapter 12. Zero without a target.
/// @pre everything finite, u_max_mps >= 0
[[nodiscard]] Eigen::Vector3d DesiredVelocity(const ConstantBearingLaw& law, double u_max_mps,
                                              const Surroundings& surroundings);

}  // namespace shoal
