#include "lib/tools/report/report_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "lib/tools/campaign/case_labels.h"
#include "lib/tools/plot/plot_script.h"
#include "lib/tools/report/report_columns.h"
#include "lib/tools/report/table_text.h"

namespace shoal {

namespace {

constexpr size_t kLabelWidth = 22;
/// Trials are named by metric up to this many cases; not_passed are always.
constexpr size_t kMaxCasesInDetail = 6;

/// Returns the numbers of the cases to show, in their order: all, or the first of each ranking.
std::vector<size_t> ChooseCases(const ReportTables& tables, bool all,
                                const std::function<double(const CaseTable&)>& value) {
  std::vector<size_t> numbers(tables.cases.size());
  std::iota(numbers.begin(), numbers.end(), size_t{0});
  if (all || numbers.size() <= kMaxCasesShown) return numbers;
  const auto key_of = [&](size_t i) {
    const CaseTable& table = tables.cases[i];
    const double of_case = value(table);
    return std::pair(table.outcomes.num_broken() + table.num_missing,
                     std::isnan(of_case) ? 0 : of_case);
  };
  std::vector<size_t> chosen;
  const auto take = [&](size_t num, auto is_before) {
    std::stable_sort(numbers.begin(), numbers.end(), is_before);
    for (const size_t number : numbers) {
      if (num == 0) return;
      if (std::find(chosen.begin(), chosen.end(), number) != chosen.end()) continue;
      chosen.push_back(number);
      --num;
    }
  };
  const auto num_flawed = static_cast<size_t>(
      std::count_if(numbers.begin(), numbers.end(), [&](size_t i) { return key_of(i).first > 0; }));
  take(std::min(num_flawed, kMaxCasesShown / 2),
       [&](size_t a, size_t b) { return key_of(a).first > key_of(b).first; });
  take((kMaxCasesShown - chosen.size()) / 2,
       [&](size_t a, size_t b) { return key_of(a).second < key_of(b).second; });
  take(kMaxCasesShown - chosen.size(),
       [&](size_t a, size_t b) { return key_of(a).second > key_of(b).second; });
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

/// Writes the report.
class ReportWriter {
 public:
  ReportWriter(const CampaignResults& results, const ReportTables& tables, bool all)
      : results_(results), tables_(tables), all_(all) {}

  std::string Write() {
    Head();
    Outcomes();
    for (size_t metric = 0; metric < results_.metrics.size(); ++metric) Metric(metric);
    return std::move(text_);
  }

 private:
  void Line(const std::string& line) { text_ += line + '\n'; }

  template <class Of>
  static std::string Headings(std::span<const ReportColumn<Of>> columns) {
    std::string line;
    for (const ReportColumn<Of>& column : columns) {
      line += fmt::format(fmt::runtime(column.format), column.heading);
    }
    return line;
  }
  template <class Of>
  static std::string Cells(std::span<const ReportColumn<Of>> columns, const Of& of) {
    std::string line;
    for (const ReportColumn<Of>& column : columns) {
      line += fmt::format(fmt::runtime(column.format), column.CellOf(of));
    }
    return line;
  }

  const CampaignCase& CaseOf(const CaseTable& table) const {
    return results_.cases[table.case_number];
  }
  std::string Label(const CaseTable& table) const {
    return ShortLabel(results_, CaseOf(table), kLabelWidth);
  }

  void Head() {
    const OutcomeCounts& of = tables_.outcomes;
    Line(fmt::format("{}: {} of {} each", ShownText(results_.campaign.file),
                     CountText(static_cast<int64_t>(tables_.cases.size()), "case"),
                     CountText(results_.campaign.repetitions, "repetition")));
    Line(fmt::format("{} of {}: {}; {} missing", CountText(of.num()),
                     CountText(tables_.num_expected, "trial"), OutcomesText(of),
                     CountText(tables_.num_missing)));
    std::vector<std::string> keys;
    if (!results_.cases.empty()) {
      for (const Setting& key : KeysOf(results_, results_.cases.front())) {
        keys.push_back(ShownText(key.key));
      }
    }
    if (!keys.empty()) Line(fmt::format("Cases are named by: {}", fmt::join(keys, ", ")));
    Line(fmt::format(
        "Intervals have a confidence of {:g} %{}", 100 * tables_.confidence,
        results_.campaign.stop ? "; those with a star hold at all looks together (repeated)" : ""));
    if (results_.num_beyond_stop > 0) {
      Line(fmt::format("{} beyond the look at which their case stopped: not in these numbers",
                       CountText(results_.num_beyond_stop, "trial")));
    }
  }

  static std::string OutcomesText(const OutcomeCounts& of) {
    return fmt::format("{} pass, {} fail, {} error, {} timeout", CountText(of[TrialOutcome::kPass]),
                       CountText(of[TrialOutcome::kFail]), CountText(of[TrialOutcome::kError]),
                       CountText(of[TrialOutcome::kTimeout]));
  }

  void Outcomes() {
    const auto shown =
        ChooseCases(tables_, all_, [](const CaseTable& table) { return table.share_passed.value; });
    Line(fmt::format("\n{:<{}}", "Outcomes", kLabelWidth) + Headings(OutcomeColumns()));
    for (const size_t number : shown) {
      const CaseTable& table = tables_.cases[number];
      Line(fmt::format("{:<{}}", Label(table), kLabelWidth) + Cells(OutcomeColumns(), table));
      Notes(table);
    }
    LeftOut(shown.size());
  }

  void Notes(const CaseTable& table) {
    const int64_t num = table.outcomes.num();
    if (table.bound_of_none) {
      const bool all_passed = table.outcomes[TrialOutcome::kPass] == num;
      Line(fmt::format("    0 of {} {}: below {} at {:g} %, one-sided", CountText(num),
                       all_passed ? "did not pass" : "passed", BoundText(*table.bound_of_none),
                       100 * table.share_passed.confidence));
    }
    if (table.num_missing > 0) {
      Line(fmt::format("    {} of {} missing", CountText(table.num_missing),
                       CountText(table.num_expected, "trial")));
    }
    if (table.has_stopped) {
      Line(fmt::format("    stopped by its rule after {}",
                       CountText(table.num_expected, "repetition")));
    }
    if (!table.undecidable_looks.empty()) {
      Line(fmt::format("    not decided at the looks {}: trials have no value of {}",
                       fmt::join(table.undecidable_looks, ", "), results_.campaign.stop->metric));
    }
    for (const NotedTrial& trial : table.not_passed) {
      Line(fmt::format("    {}-{} {}: {}", trial.key.case_id, trial.key.repetition,
                       NameOf(trial.outcome), ShownText(trial.why)));
    }
    const int64_t num_not_passed = num - table.outcomes[TrialOutcome::kPass];
    const int64_t num_more = num_not_passed - static_cast<int64_t>(table.not_passed.size());
    if (num_more > 0) {
      Line(fmt::format("    and {} more that did not pass: results.csv has all",
                       CountText(num_more)));
    }
  }

  void LeftOut(size_t num_shown) {
    const size_t num_left_out = tables_.cases.size() - num_shown;
    if (num_left_out == 0) return;
    Line(
        fmt::format("({} not shown: those above have errors, timeouts or missing trials, or the "
                    "lowest\n and highest values; --all shows every case, results.csv has every "
                    "trial)",
                    CountText(static_cast<int64_t>(num_left_out), "case")));
  }

  void Metric(size_t metric) {
    const MetricName& name = results_.metrics[metric];
    const auto shown = ChooseCases(
        tables_, all_, [&](const CaseTable& table) { return table.metrics[metric].mean.value; });
    const std::string unit = name.unit.empty() ? "" : " [" + ShownText(name.unit) + "]";
    Line(fmt::format("\n{}{}{}", ShownText(name.name), unit,
                     name.text.empty() ? "" : ": " + ShownText(name.text)));
    Line(std::string(kLabelWidth, ' ') + Headings(MetricColumns()));
    for (const size_t number : shown) {
      const CaseTable& table = tables_.cases[number];
      const MetricSummary& of = table.metrics[metric];
      Line(fmt::format("{:<{}}", Label(table), kLabelWidth) + Cells(MetricColumns(), of));
      if (of.num > 0) Quantiles(of);
      if (shown.size() <= kMaxCasesInDetail) Worst(of);
    }
    LeftOut(shown.size());
  }

  void Quantiles(const MetricSummary& of) {
    std::vector<std::string> items;
    for (size_t i = 0; i < kReportedQuantiles.size(); ++i) {
      const Estimate& quantile = of.quantiles[i];
      items.push_back(fmt::format("{:g} %: {} ({})", 100 * kReportedQuantiles[i],
                                  DigitsText(quantile.value), IntervalText(quantile.interval)));
    }
    Wrapped("   ", items);
  }

  void Worst(const MetricSummary& of) {
    std::vector<std::string> items;
    for (const NotedTrial& trial : of.worst) {
      items.push_back(fmt::format("{}-{} {} {}", trial.key.case_id, trial.key.repetition,
                                  NameOf(trial.outcome), DigitsText(trial.value)));
    }
    Wrapped("    look at", items);
  }

  /// Writes the items with commas, in as many lines as they need; none without items.
  void Wrapped(const std::string& head, const std::vector<std::string>& items) {
    if (items.empty()) return;
    std::string line = head;
    for (size_t i = 0; i < items.size(); ++i) {
      const std::string item = items[i] + (i + 1 < items.size() ? "," : "");
      if (line.size() + 1 + item.size() > 100) {
        Line(line);
        line = std::string(head.size(), ' ');
      }
      line += " " + item;
    }
    Line(line);
  }

  const CampaignResults& results_;
  const ReportTables& tables_;
  bool all_;
  std::string text_;
};

}  // namespace

std::string ReportText(const CampaignResults& results, const ReportTables& tables, bool all) {
  return ReportWriter(results, tables, all).Write();
}

}  // namespace shoal
