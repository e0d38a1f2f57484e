// The chi-square distribution: gates for measurements, bounds for tests of consistency.
#pragma once

namespace shoal {

/// Returns the probability of a value up to `value`: the regularized lower incomplete gamma
/// function (Abramowitz and Stegun, 1964, 6.5.29 and 6.5.31). @pre degrees >= 1
[[nodiscard]] double ChiSquareCumulative(int degrees, double value);

/// Returns the value that is exceeded with the probability 1 - `probability`.
/// @pre degrees >= 1, 0 <= probability < 1
[[nodiscard]] double ChiSquareQuantile(int degrees, double probability);

}  // namespace shoal
