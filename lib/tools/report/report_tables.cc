#include "lib/tools/report/report_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "lib/base/statistics/mean_interval.h"
#include "lib/base/statistics/quantile_interval.h"
#include "lib/base/statistics/share_interval.h"
#include "lib/tools/campaign/case_labels.h"
#include "lib/tools/campaign/stopping.h"

namespace shoal {

namespace {

constexpr double kMissingNumber = std::numeric_limits<double>::quiet_NaN();

NotedTrial NoteOf(const CampaignResults& results, const TrialRow& row, double value) {
  return {.key = {results.cases[row.case_number].id, row.repetition},
          .outcome = row.result.outcome,
          .value = value,
          .why = row.result.why};
}

/// Returns 0 for an error, 1 for a timeout, 2 for a fail, 3 for a pass.
int OrderOf(TrialOutcome outcome) {
  switch (outcome) {
    case TrialOutcome::kError:
      return 0;
    case TrialOutcome::kTimeout:
      return 1;
    case TrialOutcome::kFail:
      return 2;
    case TrialOutcome::kPass:
      break;
  }
  return 3;
}

/// Makes the table of one case.
class CaseBuilder {
 public:
  CaseBuilder(const CampaignResults& results, const Stopping* stopping, size_t stop_metric,
              std::span<const TrialRow> rows)
      : results_(results), stopping_(stopping), stop_metric_(stop_metric), rows_(rows) {}

  CaseTable Build(size_t case_number) {
    table_.case_number = case_number;
    for (const TrialRow& row : rows_) {
      ++table_.outcomes.of[static_cast<size_t>(row.result.outcome)];
    }
    Expect();
    BuildShare();
    for (size_t metric = 0; metric < results_.metrics.size(); ++metric) {
      table_.metrics.push_back(Summarize(metric));
    }
    NoteNotPassed();
    return std::move(table_);
  }

 private:
  /// Finds how many trials the case needs, and how many of those are missing.
  void Expect() {
    table_.num_expected = results_.campaign.repetitions;
    std::vector<double> values;  // Of the first repetitions, without a hole.
    for (const TrialRow& row : rows_) {
      if (row.repetition != static_cast<int64_t>(values.size()) + 1) break;
      if (stopping_ == nullptr) break;
      values.push_back(StopValueOf(stopping_->rule(), stop_metric_, row.result));
    }
    if (stopping_ != nullptr) {
      if (const auto end = stopping_->StopsAfter(values)) table_.num_expected = *end;
      table_.undecidable_looks = stopping_->UndecidableLooks(values);
    }
    table_.has_stopped = table_.num_expected < results_.campaign.repetitions;
    const auto num_there = std::count_if(rows_.begin(), rows_.end(), [&](const TrialRow& row) {
      return row.repetition >= 1 && row.repetition <= table_.num_expected;
    });
    table_.num_missing = table_.num_expected - num_there;
  }

  void BuildShare() {
    const int64_t num = table_.outcomes.num();
    const int64_t num_passed = table_.outcomes[TrialOutcome::kPass];
    Estimate& share = table_.share_passed;
    SetConfidence(stopping_ != nullptr && stopping_->is_of_passes(), &share);
    share.value =
        num == 0 ? kMissingNumber : static_cast<double>(num_passed) / static_cast<double>(num);
    share.interval = ShareInterval(num_passed, num, share.confidence);
    if (num > 0 && (num_passed == 0 || num_passed == num)) {
      table_.bound_of_none = BoundOfNone(num, share.confidence);
    }
  }

  void SetConfidence(bool is_repeated, Estimate* estimate) const {
    estimate->is_repeated = is_repeated;
    estimate->confidence =
        is_repeated ? stopping_->ConfidenceAt(table_.outcomes.num()) : results_.campaign.confidence;
  }

  MetricSummary Summarize(size_t metric) const {
    MetricSummary summary;
    std::vector<double> values;
    for (const TrialRow& row : rows_) {
      const double value = MetricOf(row.result, metric);
      if (!std::isnan(value)) values.push_back(value);
    }
    std::sort(values.begin(), values.end());
    summary.num = static_cast<int64_t>(values.size());
    summary.num_without = table_.outcomes.num() - summary.num;
    const Moments moments = MomentsOf(values);
    SetConfidence(stopping_ != nullptr && !stopping_->is_of_passes() && metric == stop_metric_,
                  &summary.mean);
    summary.mean.value = moments.mean;
    summary.mean.interval = MeanInterval(moments, summary.mean.confidence);
    for (size_t i = 0; i < kReportedQuantiles.size(); ++i) {
      const double confidence = results_.campaign.confidence;
      summary.quantiles[i] = {
          .value = SampleQuantile(values, kReportedQuantiles[i]),
          .interval = QuantileInterval(values, kReportedQuantiles[i], confidence),
          .confidence = confidence};
    }
    summary.min = values.empty() ? kMissingNumber : values.front();
    summary.max = values.empty() ? kMissingNumber : values.back();
    summary.worst = WorstOf(metric, SampleQuantile(values, 0.5));
    return summary;
  }

  std::vector<NotedTrial> WorstOf(size_t metric, double median) const {
    struct Candidate {
      const TrialRow* row;
      bool has_passed;
      double distance;
    };
    std::vector<Candidate> candidates;
    for (const TrialRow& row : rows_) {
      const double value = MetricOf(row.result, metric);
      if (std::isnan(value)) continue;
      const double distance = value == median ? 0 : std::abs(value - median);
      candidates.push_back({&row, row.result.outcome == TrialOutcome::kPass, distance});
    }
    const size_t num = std::min(kMaxNoted, candidates.size());
    std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(num),
                      candidates.end(), [](const Candidate& a, const Candidate& b) {
                        if (a.has_passed != b.has_passed) return b.has_passed;
                        if (a.distance != b.distance) return a.distance > b.distance;
                        return a.row->repetition < b.row->repetition;
                      });
    std::vector<NotedTrial> worst;
    for (size_t i = 0; i < num; ++i) {
      const TrialRow& row = *candidates[i].row;
      worst.push_back(NoteOf(results_, row, MetricOf(row.result, metric)));
    }
    return worst;
  }

  void NoteNotPassed() {
    for (int order = 0; order < 3; ++order) {
      for (const TrialRow& row : rows_) {
        if (table_.not_passed.size() == kMaxNoted) return;
        if (OrderOf(row.result.outcome) != order) continue;
        table_.not_passed.push_back(NoteOf(results_, row, kMissingNumber));
      }
    }
  }

  const CampaignResults& results_;
  const Stopping* stopping_;
  size_t stop_metric_;
  std::span<const TrialRow> rows_;
  CaseTable table_;
};

/// Returns the index of the metric that the rule is about; the number of metrics if the rule is
/// about passes.
size_t StopMetricOf(const CampaignResults& results, const StopRule& rule) {
  const auto found =
      std::find_if(results.metrics.begin(), results.metrics.end(),
                   [&](const MetricName& metric) { return metric.name == rule.metric; });
  return static_cast<size_t>(found - results.metrics.begin());
}

}  // namespace

ReportTables MakeReportTables(const CampaignResults& results) {
  ReportTables tables;
  tables.confidence = results.campaign.confidence;
  std::optional<Stopping> stopping;
  size_t stop_metric = results.metrics.size();
  if (results.campaign.stop) {
    stopping.emplace(*results.campaign.stop, results.campaign.repetitions);
    stop_metric = StopMetricOf(results, *results.campaign.stop);
  }
  auto begin = results.rows.begin();
  for (size_t number = 0; number < results.cases.size(); ++number) {
    const auto end = std::find_if(begin, results.rows.end(),
                                  [&](const TrialRow& row) { return row.case_number != number; });
    CaseBuilder builder(results, stopping ? &*stopping : nullptr, stop_metric, {begin, end});
    begin = end;
    tables.cases.push_back(builder.Build(number));
    const CaseTable& table = tables.cases.back();
    for (size_t i = 0; i < tables.outcomes.of.size(); ++i) {
      tables.outcomes.of[i] += table.outcomes.of[i];
    }
    tables.num_expected += table.num_expected;
    tables.num_missing += table.num_missing;
  }
  return tables;
}

}  // namespace shoal
