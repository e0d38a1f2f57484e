#include "lib/tools/report/report_columns.h"

#include <fmt/format.h>

#include <vector>

#include "lib/tools/report/table_text.h"

namespace shoal {

namespace {

/// A star marks an interval that holds at all looks together.
std::string StarredText(const std::string& interval, const Estimate& of) {
  return of.is_repeated ? interval + " *" : interval;
}

std::vector<ReportColumn<CaseTable>> MakeOutcomeColumns() {
  using Row = const CaseTable&;
  std::vector<ReportColumn<CaseTable>> columns = {
      {" {:>8}", "trials", [](Row of, size_t) { return std::to_string(of.outcomes.num()); }}};
  for (size_t i = 0; i < kTrialOutcomeNames.size(); ++i) {
    columns.push_back({i == 0 ? " {:>8}" : " {:>7}", std::string(kTrialOutcomeNames.At(i)),
                       [](Row of, size_t which) { return std::to_string(of.outcomes.of[which]); },
                       i});
  }
  columns.push_back(
      {"  {:>9}", "passed", [](Row of, size_t) { return PercentText(of.share_passed.value); }});
  columns.push_back({"  {}", "interval", [](Row of, size_t) {
                       return StarredText(PercentText(of.share_passed.interval), of.share_passed);
                     }});
  return columns;
}

std::vector<ReportColumn<MetricSummary>> MakeMetricColumns() {
  using Row = const MetricSummary&;
  std::vector<ReportColumn<MetricSummary>> columns = {
      {" {:>8}", "trials", [](Row of, size_t) { return std::to_string(of.num); }},
      {" {:>7}", "without", [](Row of, size_t) { return std::to_string(of.num_without); }},
      {" {:>10}", "mean", [](Row of, size_t) { return DigitsText(of.mean.value); }},
      {"  {:<26}", "interval",
       [](Row of, size_t) { return StarredText(IntervalText(of.mean.interval), of.mean); }}};
  // The text report has the quantiles in a line of their own.
  for (size_t i = 0; i < kReportedQuantiles.size(); ++i) {
    columns.push_back({"", fmt::format("{:g} %", 100 * kReportedQuantiles[i]),
                       [](Row of, size_t which) { return DigitsText(of.quantiles[which].value); },
                       i});
    columns.push_back(
        {"", "interval",
         [](Row of, size_t which) { return IntervalText(of.quantiles[which].interval); }, i});
  }
  columns.push_back({" {:>10}", "least", [](Row of, size_t) { return DigitsText(of.min); }});
  columns.push_back({" {:>10}", "greatest", [](Row of, size_t) { return DigitsText(of.max); }});
  return columns;
}

}  // namespace

std::span<const ReportColumn<CaseTable>> OutcomeColumns() {
  static const auto columns = MakeOutcomeColumns();
  return columns;
}

std::span<const ReportColumn<MetricSummary>> MetricColumns() {
  static const auto columns = MakeMetricColumns();
  return columns;
}

}  // namespace shoal
