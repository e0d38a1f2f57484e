#include "lib/tools/campaign/case_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "lib/base/text/numbers.h"
#include "lib/tools/plot/plot_script.h"

namespace shoal {

namespace {

std::string_view WithoutQuotes(std::string_view text) {
  const bool is_quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
                         text.back() == text.front();
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

CaseKeys KeysOf(const CampaignResults& results, const CampaignCase& of) {
  CaseKeys keys;
  const size_t num_keys = std::min(results.sweep_keys.size(), of.values.size());
  for (size_t i = 0; i < num_keys; ++i) keys.push_back({results.sweep_keys[i], of.values[i]});
  if (!of.policy.empty()) keys.push_back({std::string(kPolicyKey), of.policy});
  return keys;
}

std::string KeysText(const CaseKeys& keys) {
  if (keys.empty()) return "all";
  std::string text;
  for (const Setting& key : keys) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", ShownText(key.key),
                        ShownText(WithoutQuotes(key.value)));
  }
  return text;
}

std::string ShortLabel(const CampaignResults& results, const CampaignCase& of,
                       size_t max_characters) {
  std::string label;
  for (const Setting& key : KeysOf(results, of)) {
    label += (label.empty() ? "" : " ") + ShownText(WithoutQuotes(key.value));
  }
  if (label.empty()) return "all";
  if (label.size() <= max_characters) return label;
  const size_t kept = max_characters - std::min(max_characters, of.id.size() + 2);
  size_t end = kept;
  while (end > 0 && (static_cast<unsigned char>(label[end]) & 0xc0) == 0x80) --end;
  return label.substr(0, end) + "… " + of.id;
}

std::string TrialName(const CampaignResults& results, const TrialRow& row) {
  return TrialName({results.cases[row.case_number].id, row.repetition});
}

double MetricOf(const TrialResult& result, size_t metric) {
  return metric < result.metrics.size() ? result.metrics[metric] : TrialResult::kNoValue;
}

bool IsSameValue(std::string_view written, std::string_view toml) {
  if (written == toml || WithoutQuotes(written) == WithoutQuotes(toml)) return true;
  return NumberOf(written) == NumberOf(toml);  // Not where either is NaN.
}

double NumberOf(std::string_view toml) {
  std::string digits(toml);
  std::erase(digits, '_');
  return ReadNumber<double>(digits).value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace shoal
