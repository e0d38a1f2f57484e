// The numbers of a campaign's report, from which the text, the page and the figures are made.
// docs/campaigns/report.md documents the intervals.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/statistics/interval.h"
#include "lib/tools/campaign/results.h"

namespace shoal {

/// An estimate, and an interval of the truth with the confidence that it is stated with. A repeated
/// interval (`is_repeated`) is of a quantity that decides when the campaign stops.
struct Estimate {
  double value = 0;  ///< NaN: there is none.
  Interval interval;
  double confidence = 0.95;
  bool is_repeated = false;
};

struct OutcomeCounts {
  std::array<int64_t, kNumEnumerators<TrialOutcome>> of = {};  ///< By TrialOutcome.

  [[nodiscard]] int64_t operator[](TrialOutcome outcome) const {
    return of[static_cast<size_t>(outcome)];
  }
  [[nodiscard]] int64_t num() const { return std::accumulate(of.begin(), of.end(), int64_t{0}); }
  /// Errors and timeouts: what did not run to its end.
  [[nodiscard]] int64_t num_broken() const {
    return (*this)[TrialOutcome::kError] + (*this)[TrialOutcome::kTimeout];
  }
};

/// A trial that a reader may want to see.
struct NotedTrial {
  TrialKey key;
  TrialOutcome outcome = TrialOutcome::kPass;
  double value = 0;  ///< Of the metric; NaN: of none.
  std::string why;
};

/// The quantiles of a metric that are reported.
inline constexpr std::array<double, 3> kReportedQuantiles = {0.05, 0.5, 0.95};
/// Noted trials of a case and metric.
inline constexpr size_t kMaxNoted = 5;

/// A metric in a case.
struct MetricSummary {
  int64_t num = 0;          ///< Trials that have a value.
  int64_t num_without = 0;  ///< Those that have none.
  Estimate mean;
  std::array<Estimate, kReportedQuantiles.size()> quantiles;
  double min = 0;  ///< NaN without values, as all of the above.
  double max = 0;
  std::vector<NotedTrial> worst;  ///< Trials that did not pass first, then those that are farthest
                                  ///< from the median.
};

struct CaseTable {
  size_t case_number = 0;  ///< In CampaignResults::cases.
  OutcomeCounts outcomes;
  int64_t num_expected = 0;  ///< Repetitions of the campaign, or those up to the stop.
  int64_t num_missing = 0;   ///< Of the expected.
  bool has_stopped = false;  ///< Before all repetitions, by the rule.
  std::vector<int64_t> undecidable_looks;  ///< At which a trial without a value let it go on.
  Estimate share_passed;                   ///< Of all trials: only a pass is one.
  /// Where none failed to pass, or none passed: the bound of what was not seen, one-sided.
  std::optional<double> bound_of_none;
  std::vector<MetricSummary> metrics;  ///< In the order of CampaignResults::metrics.
  std::vector<NotedTrial> not_passed;  ///< Errors, timeouts, fails: kMaxNoted at most.
};

struct ReportTables {
  double confidence = 0.95;
  OutcomeCounts outcomes;
  int64_t num_expected = 0;
  int64_t num_missing = 0;
  std::vector<CaseTable> cases;  ///< As in CampaignResults.

  /// True where a trial is an error or a timeout, or missing: the answers are not whole.
  [[nodiscard]] bool IsFlawed() const { return outcomes.num_broken() > 0 || num_missing > 0; }
};

/// Returns the tables of the results so far.
[[nodiscard]] ReportTables MakeReportTables(const CampaignResults& results);

}  // namespace shoal
