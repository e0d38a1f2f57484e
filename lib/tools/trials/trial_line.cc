#include "lib/tools/trials/trial_line.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace shoal {

namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kLongestWhy_bytes = 4000;

std::optional<TrialOutcome> OutcomeNamed(std::string_view name) {
  return kTrialOutcomeNames.Find(name);
}

/// Throws what nlohmann::json throws.
std::optional<FinishedTrial> Parse(std::string_view line, const std::vector<MetricName>& metrics) {
  const auto json = nlohmann::json::parse(line);
  FinishedTrial trial;
  trial.key.case_id = json.at("case").get<std::string>();
  trial.key.repetition = json.at("repetition").get<int64_t>();
  const auto outcome = OutcomeNamed(json.at("outcome").get<std::string>());
  if (!outcome || trial.key.repetition < 1) return std::nullopt;
  trial.result.outcome = *outcome;
  trial.result.why = json.at("why").get<std::string>();
  trial.wall_s = json.value("wall_s", 0.0);
  trial.attempt = json.value("attempt", int64_t{0});
  trial.arithmetic = json.value("arithmetic", std::string());
  const auto& values = json.at("metrics");
  if (!values.empty() && values.size() != metrics.size()) return std::nullopt;
  trial.result.metrics.assign(metrics.size(), TrialResult::kNoValue);
  for (size_t i = 0; i < metrics.size() && !values.empty(); ++i) {
    const auto& value = values.at(metrics[i].name);
    if (!value.is_null()) trial.result.metrics[i] = value.get<double>();
  }
  return trial;
}

}  // namespace

std::string TrialLine(const FinishedTrial& trial, const std::vector<MetricName>& metrics) {
  Json json;
  json["case"] = trial.key.case_id;
  json["repetition"] = trial.key.repetition;
  json["outcome"] = NameOf(trial.result.outcome);
  json["why"] = trial.result.why.substr(0, kLongestWhy_bytes);
  Json values = Json::object();
  if (trial.result.metrics.size() == metrics.size()) {
    for (size_t i = 0; i < metrics.size(); ++i) {
      const double value = trial.result.metrics[i];
      values[metrics[i].name] = std::isfinite(value) ? Json(value) : Json();
    }
  }
  json["metrics"] = std::move(values);
  json["wall_s"] = std::round(trial.wall_s * 1e4) / 1e4;
  if (trial.attempt > 0) json["attempt"] = trial.attempt;
  if (!trial.arithmetic.empty()) json["arithmetic"] = trial.arithmetic;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<FinishedTrial> ParseTrialLine(std::string_view line,
                                            const std::vector<MetricName>& metrics) {
  try {
    return Parse(line, metrics);
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace shoal
