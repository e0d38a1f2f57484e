// Questions about single numbers that many modules ask. All are false, or 0, for NaN.
#pragma once

#include <cmath>
#include <limits>

namespace shoal {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns true where min <= value <= max.
constexpr bool IsBetween(double value, double min, double max) {
  return value >= min && value <= max;
}

/// Returns `value`, or 0 where it is NaN or infinite.
inline double FiniteOrZero(double value) { return std::isfinite(value) ? value : 0; }

}  // namespace shoal
