// Results of made-up campaigns, for tests of what is made from them.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "lib/tools/campaign/results.h"

namespace shoal {

/// Returns a campaign of these repetitions with one metric, closest_m, and no cases.
inline CampaignResults EmptyCampaign(int64_t repetitions) {
  CampaignResults results;
  results.campaign.file = "berta_campaign.toml";
  results.campaign.repetitions = repetitions;
  results.metrics = {{.name = "closest_m", .unit = "m", .text = "no two vehicles closer than 5 m"}};
  return results;
}

/// Appends a case. Its id is made of its number: 0000000000, 1111111111, ...
inline void AddCase(std::vector<std::string> values, std::string policy, CampaignResults* results) {
  const auto digit = static_cast<char>('0' + results->cases.size() % 10);
  std::string id(10, digit);
  if (results->cases.size() >= 10) id = fmt::format("{:010}", results->cases.size());
  results->cases.push_back({std::move(id), std::move(values), std::move(policy)});
}

/// Appends a trial to the last case. Its seed depends on the repetition alone.
inline void AddTrial(int64_t repetition, TrialOutcome outcome, std::vector<double> metrics,
                     CampaignResults* results) {
  TrialRow row;
  row.case_number = results->cases.size() - 1;
  row.repetition = repetition;
  row.seed = 1000 + static_cast<uint64_t>(repetition);
  row.result = {.outcome = outcome,
                .why = outcome == TrialOutcome::kPass ? "" : "why of " + std::to_string(repetition),
                .metrics = std::move(metrics)};
  results->rows.push_back(std::move(row));
}

/// Appends trials 1 .. `num`, all passed, with the metric value(repetition).
template <class Value>
void AddPasses(int64_t num, Value value, CampaignResults* results) {
  for (int64_t i = 1; i <= num; ++i) {
    AddTrial(i, TrialOutcome::kPass, {static_cast<double>(value(i))}, results);
  }
}

}  // namespace shoal
