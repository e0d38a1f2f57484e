// The time of sound in a layer, without cancellation where its gradient is small.
#pragma once

#include "lib/base/arithmetic/elementary.h"

namespace shoal {

/// Returns atanh(x) / x. @pre |x| < 1
[[nodiscard]] inline double AtanhOverX(double x) {
  const double square = x * x;
  if (square < 1e-3) {
    constexpr double k3 = 1.0 / 3, k5 = 1.0 / 5, k7 = 1.0 / 7, k9 = 1.0 / 9, k11 = 1.0 / 11;
    return 1 + square * (k3 + square * (k5 + square * (k7 + square * (k9 + square * k11))));
  }
  return Log1p(2 * x / (1 - x)) / (2 * x);
}

}  // namespace shoal
