#include "lib/tools/campaign/stopping.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/statistics/alpha_spending.h"
#include "lib/base/statistics/mean_interval.h"
#include "lib/base/statistics/share_interval.h"
#include "lib/tools/campaign/case_labels.h"

namespace shoal {

namespace {

SpendingCurve CurveOf(Spending spending) {
  return spending == Spending::kPocock ? SpendingCurve::kPocock : SpendingCurve::kObrienFleming;
}

bool HasGap(std::span<const double> values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
}

}  // namespace

Stopping::Stopping(StopRule rule, int64_t repetitions) : rule_(std::move(rule)) {
  SHOAL_CHECK(repetitions > 0, "a case has repetitions");
  std::vector<double> fractions;
  for (const int64_t num : rule_.looks) {
    SHOAL_CHECK(num > (looks_.empty() ? 0 : looks_.back().num) && num <= repetitions,
                "looks rise up to the repetitions");
    looks_.push_back({.num = num, .stops = true});
  }
  if (looks_.empty() || looks_.back().num < repetitions) looks_.push_back({.num = repetitions});
  for (const Look& look : looks_) {
    fractions.push_back(static_cast<double>(look.num) / static_cast<double>(repetitions));
  }
  const auto bounds = SpendingBounds(CurveOf(rule_.spending), 1 - rule_.confidence, fractions);
  for (size_t i = 0; i < looks_.size(); ++i) looks_[i].confidence = RepeatedConfidence(bounds[i]);
}

Interval Stopping::IntervalOf(std::span<const double> values, double confidence) const {
  if (!is_of_passes()) return MeanInterval(MomentsOf(values), confidence);
  const auto num_passes = std::count(values.begin(), values.end(), 1.0);
  return ShareInterval(num_passes, static_cast<int64_t>(values.size()), confidence);
}

std::optional<int64_t> Stopping::StopsAfter(std::span<const double> values) const {
  for (const Look& look : looks_) {
    if (!look.stops || static_cast<size_t>(look.num) > values.size()) break;
    const auto first = values.first(static_cast<size_t>(look.num));
    if (HasGap(first)) break;  // Nor can a later look do without it.
    if (IntervalOf(first, look.confidence).half_width() <= rule_.half_width) return look.num;
  }
  return std::nullopt;
}

double Stopping::ConfidenceAt(int64_t num) const {
  double confidence = looks_.front().confidence;
  for (const Look& look : looks_) {
    if (look.num <= num) confidence = look.confidence;
  }
  return confidence;
}

std::vector<int64_t> Stopping::UndecidableLooks(std::span<const double> values) const {
  std::vector<int64_t> looks;
  const std::optional<int64_t> end = StopsAfter(values);
  for (const Look& look : looks_) {
    if (!look.stops || static_cast<size_t>(look.num) > values.size()) break;
    if (end && look.num > *end) break;
    if (HasGap(values.first(static_cast<size_t>(look.num)))) looks.push_back(look.num);
  }
  return looks;
}

double StopValueOf(const StopRule& rule, size_t metric, const TrialResult& result) {
  if (rule.metric == "pass") return result.outcome == TrialOutcome::kPass ? 1 : 0;
  return MetricOf(result, metric);
}

std::optional<int64_t> StopsAfter(const StopRule& rule, int64_t repetitions,
                                  std::span<const double> values) {
  return Stopping(rule, repetitions).StopsAfter(values);
}

}  // namespace shoal
