// Quantiles of a sample, and intervals of those of what it was drawn from.
#pragma once

#include <span>

#include "lib/base/statistics/interval.h"

namespace shoal {

/// Returns the quantile at `share`, linear between order statistics (Hyndman and Fan 1996, type 7:
/// that of numpy and R); NaN without values. @pre values rise, 0 <= share <= 1
[[nodiscard]] double SampleQuantile(std::span<const double> sorted, double share);

/// Returns an interval of the distribution's quantile at `share`, whatever the distribution: from
/// one order statistic to another (Thompson 1936; David and Nagaraja 2003, Order Statistics, 7.1).
/// The ranks are those of the percentile bootstrap with unlimited resamples, where the binomial is
/// taken at `share` instead of at the sample's own rank; thus the coverage is never below the
/// confidence, and no random number is needed. An end is infinite where the sample is too small to
/// bound that side. @pre values rise, 0 < share < 1, 0 <= confidence <= 1
[[nodiscard]] Interval QuantileInterval(std::span<const double> sorted, double share,
                                        double confidence);

}  // namespace shoal
