#include "lib/tools/report/page_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <vector>

#include "lib/tools/campaign/case_labels.h"
#include "lib/tools/report/report_columns.h"
#include "lib/tools/report/table_text.h"

namespace shoal {

namespace {

using PageJson = nlohmann::json;

/// Seven significant digits: more than a chart shows, and half the size.
double Rounded(double value) {
  return std::isfinite(value) ? std::strtod(fmt::format("{:.7g}", value).c_str(), nullptr) : value;
}

/// Texts of which many are the same: each once, and the number of the text of each item.
class TextColumn {
 public:
  void Add(const std::string& text) {
    const auto [found, is_new] = numbers_.try_emplace(text, numbers_.size());
    if (is_new) texts_.push_back(text);
    of_.push_back(found->second);
  }

  PageJson AsJson() const { return {{"texts", texts_}, {"of", of_}}; }

 private:
  std::unordered_map<std::string, size_t> numbers_;
  PageJson texts_ = PageJson::array();
  PageJson of_ = PageJson::array();
};

/// Returns the numbers of the keys that vary together, for each axis.
PageJson AxesOf(const CampaignResults& results) {
  const auto number_of = [&](const std::string& key) {
    return static_cast<size_t>(
        std::find(results.sweep_keys.begin(), results.sweep_keys.end(), key) -
        results.sweep_keys.begin());
  };
  PageJson axes = PageJson::array();
  std::vector<bool> has_axis(results.sweep_keys.size());
  for (const SweepAxis& axis : results.campaign.sweep) {
    PageJson keys = PageJson::array();
    for (const std::string& key : axis.keys) {
      const size_t number = number_of(key);
      if (number == has_axis.size() || has_axis[number]) continue;
      has_axis[number] = true;
      keys.push_back(number);
    }
    if (!keys.empty()) axes.push_back(std::move(keys));
  }
  for (size_t i = 0; i < has_axis.size(); ++i) {
    if (!has_axis[i]) axes.push_back(PageJson::array({i}));
  }
  return axes;
}

PageJson EstimateJson(const Estimate& of) {
  return {of.value, of.interval.low, of.interval.high, of.is_repeated};
}

template <class Of>
PageJson HeadingsOf(std::span<const ReportColumn<Of>> columns) {
  PageJson headings = PageJson::array();
  for (const ReportColumn<Of>& column : columns) headings.push_back(column.heading);
  return headings;
}

template <class Of>
PageJson CellsOf(std::span<const ReportColumn<Of>> columns, const Of& of) {
  PageJson cells = PageJson::array();
  for (const ReportColumn<Of>& column : columns) cells.push_back(column.CellOf(of));
  return cells;
}

PageJson MetricJson(const MetricSummary& of) {
  return {{"mean", EstimateJson(of.mean)}, {"texts", CellsOf(MetricColumns(), of)}};
}

PageJson CaseJson(const CampaignCase& of, const CaseTable& table) {
  PageJson json = {{"id", of.id},
                   {"values", of.values},
                   {"policy", of.policy},
                   {"outcomes", table.outcomes.of},
                   {"expected", table.num_expected},
                   {"missing", table.num_missing},
                   {"stopped", table.has_stopped},
                   {"undecidable", table.undecidable_looks},
                   {"share", EstimateJson(table.share_passed)},
                   {"texts", CellsOf(OutcomeColumns(), table)},
                   {"confidence", table.share_passed.confidence},
                   {"bound", table.bound_of_none ? BoundText(*table.bound_of_none) : ""},
                   {"metrics", PageJson::array()}};
  for (const MetricSummary& metric : table.metrics) json["metrics"].push_back(MetricJson(metric));
  return json;
}

/// Returns {numbers} where all values are numbers, else {texts, of}.
PageJson SampleColumn(const std::vector<TrialRow>& rows, size_t key) {
  PageJson numbers = PageJson::array();
  TextColumn texts;
  bool is_numeric = true;
  for (const TrialRow& row : rows) {
    const std::string text = key < row.samples.size() ? row.samples[key] : "";
    const double number = NumberOf(text);
    is_numeric = is_numeric && std::isfinite(number);
    numbers.push_back(Rounded(number));
    texts.Add(text);
  }
  return is_numeric ? PageJson{{"numbers", std::move(numbers)}} : texts.AsJson();
}

PageJson TrialsJson(const CampaignResults& results) {
  std::vector<size_t> nums(results.cases.size());
  PageJson repetitions = PageJson::array();
  std::string outcomes;
  TextColumn whys;
  for (const TrialRow& row : results.rows) {
    ++nums[row.case_number];
    repetitions.push_back(row.repetition);
    outcomes += static_cast<char>('0' + static_cast<int>(row.result.outcome));
    whys.Add(row.result.why);
  }
  PageJson samples = PageJson::array();
  for (size_t key = 0; key < results.sampled_keys.size(); ++key) {
    samples.push_back(SampleColumn(results.rows, key));
  }
  PageJson metrics = PageJson::array();
  for (size_t metric = 0; metric < results.metrics.size(); ++metric) {
    PageJson column = PageJson::array();
    for (const TrialRow& row : results.rows)
      column.push_back(Rounded(MetricOf(row.result, metric)));
    metrics.push_back(std::move(column));
  }
  return {{"of_case", nums},
          {"repetition", std::move(repetitions)},
          {"outcome", outcomes},
          {"why", whys.AsJson()},
          {"samples", std::move(samples)},
          {"metrics", std::move(metrics)}};
}

}  // namespace

std::string PageData(const CampaignResults& results, const ReportTables& tables,
                     const std::string& dir) {
  PageJson json = {{"file", results.campaign.file},
                   {"mission", results.campaign.mission_file},
                   {"dir", dir},
                   {"repetitions", results.campaign.repetitions},
                   {"confidence", tables.confidence},
                   {"outcomes", tables.outcomes.of},
                   {"expected", tables.num_expected},
                   {"missing", tables.num_missing},
                   {"beyond_stop", results.num_beyond_stop},
                   {"stop_metric", results.campaign.stop ? results.campaign.stop->metric : ""},
                   {"keys", results.sweep_keys},
                   {"axes", AxesOf(results)},
                   {"sampled", results.sampled_keys},
                   {"outcome_columns", HeadingsOf(OutcomeColumns())},
                   {"metric_columns", HeadingsOf(MetricColumns())},
                   {"metrics", PageJson::array()},
                   {"cases", PageJson::array()},
                   {"trials", TrialsJson(results)}};
  for (const MetricName& metric : results.metrics) {
    json["metrics"].push_back(
        {{"name", metric.name}, {"unit", metric.unit}, {"text", metric.text}});
  }
  for (const CaseTable& table : tables.cases) {
    json["cases"].push_back(CaseJson(results.cases[table.case_number], table));
  }
  // A text of a folder from elsewhere may be no UTF-8.
  const std::string text = json.dump(-1, ' ', true, PageJson::error_handler_t::replace);
  std::string escaped;
  escaped.reserve(text.size());
  for (const char letter : text) {
    if (letter == '<') {
      escaped += "\\u003c";
    } else {
      escaped += letter;
    }
  }
  return escaped;
}

}  // namespace shoal
