// The mean of a sample, and an interval of the mean of what it was drawn from.
#pragma once

#include <cstdint>
#include <span>

#include "lib/base/statistics/interval.h"

namespace shoal {

struct Moments {
  int64_t num = 0;
  double mean = 0;                ///< NaN without values.
  double standard_deviation = 0;  ///< With num - 1; NaN below two values.
};

/// Returns them by Welford's recurrence (1962), which loses nothing where the mean is large.
[[nodiscard]] Moments MomentsOf(std::span<const double> values);

/// Returns Student's t interval of the mean (Student 1908): exact for a normal distribution, near
/// for others as `num` grows. Without ends below two values or where a value is not finite.
/// @pre 0 <= confidence <= 1
[[nodiscard]] Interval MeanInterval(const Moments& moments, double confidence);

}  // namespace shoal
