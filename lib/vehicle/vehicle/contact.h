// When two vehicles touch.
//
//   if (InContact(a_m, 1.6, b_m, 1.6)) a.immobilized = b.immobilized = true;
#pragma once

#include <Eigen/Core>

namespace shoal {

/// Returns whether two vehicles touch: their centres are closer than the mean of their lengths,
/// however they lie. Two lengths of L: closer than L, muNet's rule, but in double and from the
/// difference of the positions. Positions that are not finite touch nothing. @pre lengths >= 0
[[nodiscard]] inline bool InContact(const Eigen::Vector3d& a_m, double a_length_m,
                                    const Eigen::Vector3d& b_m, double b_length_m) {
  return (a_m - b_m).norm() < (a_length_m + b_length_m) / 2;
}

}  // namespace shoal
