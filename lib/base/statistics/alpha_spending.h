// Looking at data several times while they come, without erring more often than stated.
//
//   const auto bounds = SpendingBounds(SpendingCurve::kObrienFleming, 0.05, {{0.2, 0.5, 1}});
//
// A test at 5 % that is made at every look errs far more often than in 5 %. Here the error
// probability is divided among the looks by a curve (Lan and DeMets 1983, "Discrete sequential
// boundaries for clinical trials"), and each look has its own, wider bound.
#pragma once

#include <span>
#include <vector>

namespace shoal {

enum class SpendingCurve {
  kObrienFleming,  ///< Little at first: 4 - 4 cdf(z / sqrt(t)), z the quantile at 1 - alpha / 4.
  kPocock,         ///< Evenly: alpha ln(1 + (e - 1) t).
};

/// Returns how much of `alpha` is spent when the share `fraction` of all data is there (Lan and
/// DeMets 1983, alpha_1* and alpha_2*, for each side the half). @pre 0 <= fraction <= 1
[[nodiscard]] double SpentAlpha(SpendingCurve curve, double alpha, double fraction);

/// Returns for each look the |z| beyond which it is decided: at the true value the probability of
/// ever being beyond is `alpha`. By recursive numerical integration (Armitage, McPherson and Rowe
/// 1969; Jennison and Turnbull 2000, chapter 19). Infinite at a look that may spend less than
/// 1e-15. @pre 0 < alpha < 1; fractions rise, each above 0 and up to 1
[[nodiscard]] std::vector<double> SpendingBounds(SpendingCurve curve, double alpha,
                                                 std::span<const double> fractions);

/// Returns the confidence of an interval at a look with this bound: intervals at all looks made so
/// cover the true value together with 1 - alpha (repeated confidence intervals, Jennison and
/// Turnbull 1989). 1 where the bound is infinite.
[[nodiscard]] double RepeatedConfidence(double bound);

}  // namespace shoal
