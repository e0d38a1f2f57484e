#include "lib/tools/metrics/read_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_reader.h"
#include "lib/tools/metrics/metric_kinds.h"

namespace shoal {

namespace {

constexpr size_t kMaxMetrics = 1000;

/// Returns why no metric can have this name; empty: it can.
std::string MetricNameProblem(std::string_view name) {
  const bool is_legal =
      !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), IsNameCharacter);
  if (!is_legal) {
    return fmt::format("the name of a metric has 1 to 64 letters, digits and '_', not {}",
                       Quoted(name));
  }
  if (name == "pass" || name.starts_with("expect_")) {
    return fmt::format("{} is the name of what a campaign has without asking: choose another",
                       Quoted(name));
  }
  return "";
}

MetricSpec ReadMetric(const Entry& entry, Problems& problems) {
  TableReader fields(entry.value, fmt::format("metric {}", Quoted(entry.key)), problems);
  MetricSpec spec;
  spec.name = entry.key;
  if (!std::holds_alternative<Table>(entry.value.data)) return spec;
  std::vector<std::string_view> words;
  for (const MetricKindRow& row : MetricKindTable()) words.push_back(row.word);
  std::string word;
  const bool has_channel = fields.Has("channel", false);
  if (!has_channel) fields.Require("kind", "kind = \"closest_approach\"");
  fields.Word("kind", word, words);
  if (word.empty() && has_channel && !fields.Has("kind", false)) word = "field";
  const auto found = std::ranges::find(MetricKindTable(), word, &MetricKindRow::word);
  if (found == MetricKindTable().end()) {
    fields.SkipRest();  // Which keys are right depends on the kind.
    return spec;
  }
  spec.kind = found->kind;
  found->read(fields, &spec);
  return spec;
}

}  // namespace

void ReadMetrics(const Value& table, Problems& problems, std::vector<MetricSpec>* metrics) {
  metrics->clear();
  const auto* entries = std::get_if<Table>(&table.data);
  if (entries == nullptr) {
    problems.Add(table.place, "metrics must be a table like [metrics], not " + WhatIs(table));
    return;
  }
  if (entries->size() > kMaxMetrics) {
    problems.Add(table.place,
                 fmt::format("[metrics] has {} metrics; {} at most", entries->size(), kMaxMetrics));
    return;
  }
  for (const Entry& entry : *entries) {
    if (std::string problem = MetricNameProblem(entry.key); !problem.empty()) {
      problems.Add(entry.key_place, std::move(problem));
    }
    metrics->push_back(ReadMetric(entry, problems));
  }
  std::sort(metrics->begin(), metrics->end(),
            [](const MetricSpec& a, const MetricSpec& b) { return a.name < b.name; });
}

}  // namespace shoal
