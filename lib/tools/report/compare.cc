#include "lib/tools/report/compare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>

namespace shoal {

namespace {

constexpr size_t kMaxNamed = 12;

/// Splits at commas outside of brackets and quotes: values may be arrays and texts.
std::vector<std::string> SplitAtCommas(std::string_view text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (const char letter : text) {
    if (quote != 0) {
      if (letter == quote) quote = 0;
    } else if (letter == '"' || letter == '\'') {
      quote = letter;
    } else if (letter == '[' || letter == '{') {
      ++depth;
    } else if (letter == ']' || letter == '}') {
      --depth;
    }
    if (letter == ',' && depth <= 0 && quote == 0) {
      parts.emplace_back();
    } else if (letter != ' ' || !parts.back().empty()) {
      parts.back() += letter;
    }
  }
  return parts;
}

/// Returns what the campaign's cases differ in, each key with its values.
std::string Choices(const CampaignResults& results) {
  std::vector<std::pair<std::string, std::vector<std::string>>> choices;
  for (const CampaignCase& each : results.cases) {
    const CaseKeys keys = KeysOf(results, each);
    choices.resize(std::max(choices.size(), keys.size()));
    for (size_t i = 0; i < keys.size(); ++i) {
      choices[i].first = keys[i].key;
      auto& values = choices[i].second;
      if (std::find(values.begin(), values.end(), keys[i].value) == values.end()) {
        values.push_back(keys[i].value);
      }
    }
  }
  std::string text;
  for (auto& [key, values] : choices) {
    const bool is_long = values.size() > kMaxNamed;
    if (is_long) values.resize(kMaxNamed);
    text += fmt::format("\n  {} = {}{}", key, fmt::join(values, ", "), is_long ? ", ..." : "");
  }
  return text.empty() ? "\n  nothing: the campaign has one case" : text;
}

Result<CaseKeys> ParseSelection(const CampaignResults& results, std::string_view option,
                                std::string_view text) {
  CaseKeys selection;
  for (const std::string& part : SplitAtCommas(text)) {
    const size_t equals = part.find('=');
    if (equals == part.npos || equals == 0 || equals + 1 == part.size()) {
      return Error{fmt::format("{} {}: '{}' is not KEY=VALUE. The cases differ in:{}", option, text,
                               part, Choices(results))};
    }
    selection.push_back({part.substr(0, equals), part.substr(equals + 1)});
    const bool has_policies = !results.cases.empty() && !results.cases.front().policy.empty();
    const auto& keys = results.sweep_keys;
    const std::string& key = selection.back().key;
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    if (key == kPolicyKey && has_policies) continue;
    return Error{fmt::format("{} {}: the campaign sweeps no '{}'. The cases differ in:{}", option,
                             text, key, Choices(results))};
  }
  return selection;
}

bool IsSelected(const CaseKeys& keys, const CaseKeys& selection) {
  return std::all_of(selection.begin(), selection.end(), [&](const Setting& wanted) {
    return std::any_of(keys.begin(), keys.end(), [&](const Setting& has) {
      return has.key == wanted.key && IsSameValue(wanted.value, has.value);
    });
  });
}

std::vector<size_t> CasesOf(const CampaignResults& results, const CaseKeys& selection) {
  std::vector<size_t> numbers;
  for (size_t i = 0; i < results.cases.size(); ++i) {
    if (IsSelected(KeysOf(results, results.cases[i]), selection)) numbers.push_back(i);
  }
  return numbers;
}

/// Returns the keys of a case that are not in `named`.
CaseKeys RestOf(const CampaignResults& results, size_t number, const std::set<std::string>& named) {
  CaseKeys rest = KeysOf(results, results.cases[number]);
  std::erase_if(rest, [&](const Setting& key) { return named.contains(key.key); });
  return rest;
}

/// Returns a text that no other keys and values have.
std::string IdentityOf(const CaseKeys& keys) {
  std::string text;
  for (const Setting& key : keys) text += key.AsOverride() + '\n';
  return text;
}

bool IsBroken(const TrialRow& row) {
  return row.result.outcome == TrialOutcome::kError || row.result.outcome == TrialOutcome::kTimeout;
}

using RowPair = std::pair<const TrialRow*, const TrialRow*>;

MetricComparison CompareMetric(const std::vector<RowPair>& pairs, size_t metric,
                               double confidence) {
  MetricComparison comparison;
  std::vector<double> of_a;
  std::vector<double> of_b;
  for (const auto& [a, b] : pairs) {
    const double value_a = MetricOf(a->result, metric);
    const double value_b = MetricOf(b->result, metric);
    if (std::isnan(value_a) || std::isnan(value_b)) {
      ++comparison.num_without;
      continue;
    }
    of_a.push_back(value_a);
    of_b.push_back(value_b);
  }
  comparison.means = ComparePairs(of_a, of_b, confidence);
  return comparison;
}

std::span<const TrialRow> RowsOf(const CampaignResults& results, size_t number) {
  const auto begin =
      std::partition_point(results.rows.begin(), results.rows.end(),
                           [&](const TrialRow& row) { return row.case_number < number; });
  const auto end = std::partition_point(
      begin, results.rows.end(), [&](const TrialRow& row) { return row.case_number == number; });
  return {begin, end};
}

void CountPair(const CampaignResults& results, const TrialRow& a, const TrialRow& b,
               ComparedPoint* point) {
  const bool a_passes = a.result.outcome == TrialOutcome::kPass;
  const bool b_passes = b.result.outcome == TrialOutcome::kPass;
  ++point->num_pairs;
  ++(a_passes && b_passes ? point->both_pass
     : a_passes           ? point->only_a
     : b_passes           ? point->only_b
                          : point->neither);
  if (a.seed != b.seed) ++point->num_other_seed;
  if (!IsBroken(a) && !IsBroken(b)) return;
  point->broken.push_back({.a = TrialName(results, a),
                           .b = TrialName(results, b),
                           .outcome_a = a.result.outcome,
                           .outcome_b = b.result.outcome});
}

/// Compares two cases by repetition.
ComparedPoint ComparePoint(const CampaignResults& results, size_t case_a, size_t case_b) {
  ComparedPoint point{.rest = {}, .case_a = case_a, .case_b = case_b, .broken = {}, .metrics = {}};
  std::vector<RowPair> pairs;
  const auto rows_a = RowsOf(results, case_a);
  const auto rows_b = RowsOf(results, case_b);
  auto b = rows_b.begin();
  for (const TrialRow& a : rows_a) {
    while (b != rows_b.end() && b->repetition < a.repetition) ++b;
    if (b == rows_b.end() || b->repetition != a.repetition) continue;
    pairs.emplace_back(&a, &*b);
    CountPair(results, a, *b, &point);
  }
  point.num_alone = static_cast<int64_t>(rows_a.size() + rows_b.size()) - 2 * point.num_pairs;
  point.p = McNemarExact(point.only_a, point.only_b);
  for (size_t metric = 0; metric < results.metrics.size(); ++metric) {
    point.metrics.push_back(CompareMetric(pairs, metric, results.campaign.confidence));
  }
  return point;
}

}  // namespace

Result<CampaignComparison> CompareCases(const CampaignResults& results, std::string_view a,
                                        std::string_view b) {
  CampaignComparison comparison{.a = std::string(a),
                                .b = std::string(b),
                                .confidence = results.campaign.confidence,
                                .points = {},
                                .without_partner = {}};
  std::set<std::string> named;
  std::vector<std::vector<size_t>> cases;
  for (const auto& [option, text] : {std::pair("--a", a), std::pair("--b", b)}) {
    Result<CaseKeys> selection = ParseSelection(results, option, text);
    if (!selection.ok()) return Error{selection.error()};
    for (const Setting& key : *selection) named.insert(key.key);
    cases.push_back(CasesOf(results, *selection));
    if (cases.back().empty()) {
      return Error{fmt::format("{} {} matches no case. The cases differ in:{}", option, text,
                               Choices(results))};
    }
  }
  std::map<std::string, size_t> partners;  // By IdentityOf the rest.
  for (const size_t number : cases[1]) {
    const CaseKeys rest = RestOf(results, number, named);
    if (partners.emplace(IdentityOf(rest), number).second) continue;
    return Error{
        fmt::format("--b {} leaves several cases to pair at {}: name more of their keys "
                    "in --b. The cases differ in:{}",
                    b, KeysText(rest), Choices(results))};
  }
  std::set<std::string> used;
  for (const size_t number : cases[0]) {
    const CaseKeys rest = RestOf(results, number, named);
    const std::string text = IdentityOf(rest);
    if (!used.insert(text).second) {
      return Error{
          fmt::format("--a {} leaves several cases to pair at {}: name more of their keys "
                      "in --a. The cases differ in:{}",
                      a, KeysText(rest), Choices(results))};
    }
    const auto partner = partners.find(text);
    if (partner == partners.end()) {
      comparison.without_partner.push_back(number);
      continue;
    }
    if (partner->second == number) {
      return Error{
          fmt::format("--a {} and --b {} select the same cases: name two that differ", a, b)};
    }
    comparison.points.push_back(ComparePoint(results, number, partner->second));
    comparison.points.back().rest = rest;
  }
  for (const auto& [rest, number] : partners) {
    if (!used.contains(rest)) comparison.without_partner.push_back(number);
  }
  if (comparison.points.empty()) {
    return Error{fmt::format("no case of --a {} has a partner in --b {}. The cases differ in:{}", a,
                             b, Choices(results))};
  }
  return comparison;
}

}  // namespace shoal
