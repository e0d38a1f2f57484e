// The time of sound in a layer, without cancellation where its gradient is small.
#pragma once

#include "lib/base/arithmetic/elementary.h"

namespace shoal {

/// Returns atanh(x) / x. @pre |x| < 1
[[nodiscard]] inline double AtanhOverX(double x) {
  const double square = x * x;
  if (square < 2.5e-3) {
    double sum = 1.0 / 13;
    for (const double divisor : {11.0, 9.0, 7.0, 5.0, 3.0, 1.0}) sum = 1 / divisor + square * sum;
    return sum;
  }
  return Log1p(2 * x / (1 - x)) / (2 * x);
}

}  // namespace shoal
