// When a case of a campaign needs no more repetitions.
//
// A look is at the first looks[k] repetitions of a case, in the order of their numbers, whatever
// was finished when: the answer does not depend on how many workers there were. The interval of a
// look is a repeated confidence interval: those of all looks, and that of all repetitions at the
// end, cover together (lib/base/statistics/alpha_spending.h). docs/campaigns/report.md has why.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lib/base/statistics/interval.h"
#include "lib/tools/campaign/campaign.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

class Stopping {
 public:
  /// @pre rule.looks rise, each from 1 to `repetitions`; repetitions > 0
  Stopping(StopRule rule, int64_t repetitions);

  /// Returns the number of repetitions after which a case stops, or nothing if it goes on. `values`
  /// are those of its first repetitions (ValueOf each). NaN is a trial without a value: a look at
  /// a mean with such a trial decides nothing.
  [[nodiscard]] std::optional<int64_t> StopsAfter(std::span<const double> values) const;

  /// Returns the confidence that an interval has to be made with where `num` repetitions are there,
  /// to be one of the repeated ones: that of the last look not beyond `num`; before the first, that
  /// of the first.
  [[nodiscard]] double ConfidenceAt(int64_t num) const;

  /// Returns the looks up to `values.size()` that trials without a value left undecided.
  [[nodiscard]] std::vector<int64_t> UndecidableLooks(std::span<const double> values) const;

  bool is_of_passes() const { return rule_.metric == "pass"; }
  const StopRule& rule() const { return rule_; }

 private:
  struct Look {
    int64_t num = 0;
    double confidence = 0;
    bool stops = false;  ///< False for the end of all repetitions, unless that is a look.
  };

  [[nodiscard]] Interval IntervalOf(std::span<const double> values, double confidence) const;

  StopRule rule_;
  std::vector<Look> looks_;
};

/// Returns what a trial counts as under a rule: 1 for a pass and 0 for all else where the rule is
/// of passes; otherwise its metric number `metric`, NaN where it has none.
[[nodiscard]] double StopValueOf(const StopRule& rule, size_t metric, const TrialResult& result);

/// Stopping(rule, repetitions).StopsAfter(values), for a single question.
[[nodiscard]] std::optional<int64_t> StopsAfter(const StopRule& rule, int64_t repetitions,
                                                std::span<const double> values);

}  // namespace shoal
