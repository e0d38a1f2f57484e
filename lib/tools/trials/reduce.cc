#include "lib/tools/trials/reduce.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "lib/base/text/terminal_text.h"
#include "lib/bus/os/replace_file.h"
#include "lib/bus/record/csv_rows.h"
#include "lib/tools/campaign/plan.h"
#include "lib/tools/campaign/samples.h"
#include "lib/tools/trials/stop_values.h"

namespace shoal {

namespace {

void AppendCell(std::string_view text, std::string* line) {
  *line += ',';
  AppendCsvCell(text, line);
}

/// A text without the quotes and escapes of TOML, where it is no more than a word.
std::string PlainText(const std::string& toml) {
  const bool is_quoted = toml.size() >= 2 && toml.front() == '"' && toml.back() == '"';
  if (!is_quoted || toml.find('\\') != std::string::npos) return toml;
  return toml.substr(1, toml.size() - 2);
}

}  // namespace

CampaignResults ResultsOf(const CampaignFolder& folder, const StoredTrials& stored) {
  CampaignResults results;
  results.campaign = folder.campaign;
  results.sweep_keys = SweepKeys(folder.campaign);
  for (const SampledKey& key : folder.campaign.samples) results.sampled_keys.push_back(key.key);
  results.cases = folder.plan.cases;
  results.metrics = folder.plan.metrics;
  const std::optional<StopValues> stop = StopValuesOf(folder);
  for (size_t number = 0; number < stored.by_case.size(); ++number) {
    int64_t last = folder.campaign.repetitions;
    if (stop) {
      std::map<int64_t, double> values;
      for (const auto& [repetition, trial] : stored.by_case[number]) {
        values[repetition] = stop->Of(trial.result);
      }
      last = stop->StopsAfter(values, last).value_or(last);
    }
    for (const auto& [repetition, trial] : stored.by_case[number]) {
      if (repetition > last) {
        ++results.num_beyond_stop;
        continue;
      }
      results.rows.push_back({.case_number = number,
                              .repetition = repetition,
                              .seed = SeedOf(folder.campaign, repetition),
                              .samples = SamplesOf(folder.campaign, repetition),
                              .result = trial.result});
    }
  }
  return results;
}

std::string ResultsCsv(const CampaignResults& results) {
  std::string text = "case";
  for (const std::string& key : results.sweep_keys) AppendCell(key, &text);
  text += ",policy,repetition,seed";
  for (const std::string& key : results.sampled_keys) AppendCell(key, &text);
  text += ",outcome,why";
  for (const MetricName& metric : results.metrics) AppendCell(metric.name, &text);
  text += '\n';
  for (const TrialRow& row : results.rows) {
    const CampaignCase& each = results.cases[row.case_number];
    text += each.id;
    for (const std::string& value : each.values) AppendCell(PlainText(value), &text);
    AppendCell(each.policy, &text);
    text += fmt::format(",{},{}", row.repetition, row.seed);
    for (const std::string& sample : row.samples) AppendCell(PlainText(sample), &text);
    AppendCell(NameOf(row.result.outcome), &text);
    AppendCell(row.result.why, &text);
    for (const double value : row.result.metrics) {
      text += ',';
      if (!std::isnan(value)) text += fmt::format("{}", value);
    }
    text += '\n';
  }
  return text;
}

Result<CampaignResults> ReadResults(const CampaignFolder& folder) {
  const Result<StoredTrials> stored = ReadShards(folder);
  if (!stored.ok()) return Error{stored.error()};
  if (!stored->of_other_arithmetic.empty()) {
    std::string shards;
    for (const auto& [shard, arithmetic] : stored->of_other_arithmetic) {
      shards += fmt::format("{}shards/{} ({})", shards.empty() ? "" : ", ", shard,
                            TerminalLine(arithmetic, 16));
    }
    return Error{fmt::format(
        "{}: the campaign's arithmetic is {}; trials of another one are in {}: results of two "
        "are not mixed; take these files away and run the campaign again",
        folder.path, TerminalLine(folder.plan.arithmetic, 16), shards)};
  }
  if (!stored->differing.empty()) {
    return Error{fmt::format(
        "{}: the trial {} stands there with two different results ({} trials do): they are not of "
        "one build; run the campaign into a new folder",
        folder.path, TrialName(stored->differing.front()), stored->differing.size())};
  }
  return ResultsOf(folder, *stored);
}

Result<CampaignResults> ReduceCampaign(const CampaignFolder& folder) {
  Result<CampaignResults> read = ReadResults(folder);
  if (!read.ok()) return read;
  const CampaignResults& results = *read;
  const std::filesystem::path path(folder.path);
  std::string problem = ReplaceFile((path / "results.csv").string(), ResultsCsv(results));
  if (problem.empty()) {
    problem = WriteResultsSqlite(results, (path / "results.sqlite").string());
  }
  if (!problem.empty()) return Error{problem};
  return read;
}

}  // namespace shoal
