#include "lib/base/statistics/mean_interval.h"

#include <cmath>
#include <limits>

#include "lib/base/statistics/distributions.h"

namespace shoal {

Moments MomentsOf(std::span<const double> values) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Moments moments;
  double sum_of_squares = 0;
  for (const double value : values) {
    ++moments.num;
    const double before = value - moments.mean;
    moments.mean += before / static_cast<double>(moments.num);
    sum_of_squares += before * (value - moments.mean);
  }
  if (moments.num == 0) moments.mean = kNone;
  moments.standard_deviation =
      moments.num < 2 ? kNone : std::sqrt(sum_of_squares / static_cast<double>(moments.num - 1));
  return moments;
}

Interval MeanInterval(const Moments& moments, double confidence) {
  if (moments.num < 2 || !std::isfinite(moments.mean) ||
      !std::isfinite(moments.standard_deviation)) {
    return {};
  }
  if (moments.standard_deviation == 0) return {moments.mean, moments.mean};
  const auto n = static_cast<double>(moments.num);
  const double half_width =
      StudentCritical(n - 1, confidence) * moments.standard_deviation / std::sqrt(n);
  return {moments.mean - half_width, moments.mean + half_width};
}

}  // namespace shoal
