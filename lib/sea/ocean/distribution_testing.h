// Compares samples with the distribution that they should have.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace shoal {

/// Returns the Kolmogorov-Smirnov distance of `samples` from a distribution, times sqrt(n). That of
/// samples that do come from it exceeds 1.95 once in 1000 times (Kolmogorov, 1933).
inline double KolmogorovSmirnov(std::vector<double> samples,
                                const std::function<double(double)>& cumulative) {
  std::sort(samples.begin(), samples.end());
  const auto count = static_cast<double>(samples.size());
  double distance = 0;
  for (size_t i = 0; i < samples.size(); ++i) {
    const double expected = cumulative(samples[i]);
    distance = std::max({distance, expected - static_cast<double>(i) / count,
                         static_cast<double>(i + 1) / count - expected});
  }
  return distance * std::sqrt(count);
}
inline constexpr double kKolmogorov999 = 1.95;

/// Returns the probability of a value up to `value` in the normal distribution.
inline double NormalCumulative(double value) { return std::erfc(-value / std::sqrt(2.0)) / 2; }

}  // namespace shoal
