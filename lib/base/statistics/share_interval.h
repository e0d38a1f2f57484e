// Intervals of a share: of a probability, from successes in independent trials.
#pragma once

#include <cstdint>

#include "lib/base/statistics/interval.h"

namespace shoal {

/// Returns Wilson's score interval with continuity correction (Newcombe 1998, "Two-sided confidence
/// intervals for the single proportion", method 4). @pre 0 <= successes <= trials, trials > 0
[[nodiscard]] Interval WilsonInterval(int64_t successes, int64_t trials, double confidence);

/// Returns the interval of Clopper and Pearson (1934): the coverage is never below the confidence.
/// @pre as of WilsonInterval
[[nodiscard]] Interval ExactShareInterval(int64_t successes, int64_t trials, double confidence);

/// Returns the smallest interval that contains both of the above: Wilson's alone covers less than
/// stated at confidences above 0.95, as docs/campaigns/report.md shows. 0 to 1 without trials.
/// @pre 0 <= successes <= trials, 0 <= confidence <= 1
[[nodiscard]] Interval ShareInterval(int64_t successes, int64_t trials, double confidence);

/// Returns the greatest probability of what was seen 0 times in `trials`, one-sided: the p at which
/// (1 - p)^trials = 1 - confidence (at 0.95 the "rule of three": about 3 / trials). 1 without
/// trials. @pre trials >= 0, 0 <= confidence < 1
[[nodiscard]] double BoundOfNone(int64_t trials, double confidence);

}  // namespace shoal
