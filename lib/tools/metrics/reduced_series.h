// Makes one number of many.
//
//   ReducedSeries depth(Reduction::kPercentile, 95);
//   depth.Add(12.5);
//   depth.Value();   // 12.5
#pragma once

#include <cstdint>
#include <vector>

#include "lib/tools/metrics/metric.h"

namespace shoal {

class ReducedSeries {
 public:
  /// `percentile` in (0, 100], of kPercentile.
  ReducedSeries(Reduction reduction, double percentile)
      : reduction_(reduction), percentile_(percentile) {}

  /// Adds a value. Leaves out what is not finite.
  void Add(double value);

  /// Returns the smallest, the largest, the mean, the last, or the smallest value that at least
  /// this percentage of the values does not exceed (the nearest rank, exact).
  /// TrialResult::kNoValue where no value was added.
  [[nodiscard]] double Value() const;

 private:
  Reduction reduction_;
  double percentile_;
  int64_t count_ = 0;
  double sum_ = 0;
  double smallest_ = 0;
  double largest_ = 0;
  double last_ = 0;
  std::vector<double> values_;  ///< Of kPercentile.
};

}  // namespace shoal
