// The distributions that intervals and tests are made of.
#pragma once

#include <cstdint>

namespace shoal {

/// Returns the probability of a standard normal value up to `z` (Abramowitz and Stegun 1964,
/// 26.2.29), accurate in both tails.
[[nodiscard]] double NormalCumulative(double z);

/// Returns the value that a standard normal one is below with `probability`: -infinity at 0,
/// +infinity at 1, NaN outside.
[[nodiscard]] double NormalQuantile(double probability);

/// Returns the regularized incomplete beta function I_x(a, b) (Abramowitz and Stegun 26.5.1): 0 for
/// x <= 0, 1 for x >= 1. @pre a > 0, b > 0
[[nodiscard]] double RegularizedBeta(double a, double b, double x);

/// Returns the x at which I_x(a, b) is `probability`. @pre a > 0, b > 0, 0 <= probability <= 1
[[nodiscard]] double BetaQuantile(double a, double b, double probability);

/// Returns the probability that Student's t is farther from 0 than `t`, on either side (Abramowitz
/// and Stegun 26.7.1, 26.5.27). @pre degrees > 0
[[nodiscard]] double StudentTwoSidedTail(double degrees, double t);

/// Returns the probability of Student's t up to `t`. @pre degrees > 0
[[nodiscard]] double StudentCumulative(double degrees, double t);

/// Returns the t > 0 of which StudentTwoSidedTail is 1 - `confidence`: infinity at 1.
/// @pre degrees > 0, 0 <= confidence <= 1
[[nodiscard]] double StudentCritical(double degrees, double confidence);

/// Returns the probability of at most `successes` in `trials` (Abramowitz and Stegun 26.5.24).
/// @pre trials >= 0, 0 <= probability <= 1
[[nodiscard]] double BinomialCumulative(int64_t successes, int64_t trials, double probability);

}  // namespace shoal
