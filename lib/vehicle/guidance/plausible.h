// What guidance lets in: finite vectors, of a size whose squares still are numbers.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "lib/base/check/check.h"

namespace shoal {

/// Beyond this no coordinate (m) or velocity (m/s) goes: arithmetic on it cannot overflow.
inline constexpr double kLargestCoordinate = 1e12;

/// Returns `value` within +-kLargestCoordinate. @pre finite: values of peers and sensors are
/// checked where they come in.
[[nodiscard]] inline double Plausible(double value) {
  SHOAL_CHECK(std::isfinite(value), "inputs of guidance are finite");
  return std::clamp(value, -kLargestCoordinate, kLargestCoordinate);
}

[[nodiscard]] inline Eigen::Vector3d Plausible(const Eigen::Vector3d& vector) {
  return {Plausible(vector.x()), Plausible(vector.y()), Plausible(vector.z())};
}

/// Returns `vector`, shortened to `max_norm` where it is longer.
[[nodiscard]] inline Eigen::Vector3d ClampNorm(const Eigen::Vector3d& vector, double max_norm) {
  const double norm = vector.norm();
  return norm > max_norm ? Eigen::Vector3d(vector * (max_norm / norm)) : vector;
}

}  // namespace shoal
