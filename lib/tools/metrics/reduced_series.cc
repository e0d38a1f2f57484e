#include "lib/tools/metrics/reduced_series.h"

#include <algorithm>
#include <cmath>

#include "lib/tools/analysis/comms_links.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

void ReducedSeries::Add(double value) {
  if (!std::isfinite(value)) return;
  smallest_ = count_ == 0 ? value : std::min(smallest_, value);
  largest_ = count_ == 0 ? value : std::max(largest_, value);
  last_ = value;
  sum_ += value;
  ++count_;
  if (reduction_ == Reduction::kPercentile) values_.push_back(value);
}

double ReducedSeries::Value() const {
  if (count_ == 0) return TrialResult::kNoValue;
  switch (reduction_) {
    case Reduction::kMin:
      return smallest_;
    case Reduction::kMax:
      return largest_;
    case Reduction::kMean:
      return sum_ / static_cast<double>(count_);
    case Reduction::kPercentile:
      return Percentile(values_, percentile_ / 100);
    case Reduction::kLast:
      break;
  }
  return last_;
}

}  // namespace shoal
