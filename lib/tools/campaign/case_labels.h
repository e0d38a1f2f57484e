// How texts, figures and comparisons name a case of a campaign.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/campaign/results.h"

namespace shoal {

/// One key of a case and its value. The policy's key is "policy".
using CaseKeys = std::vector<Setting>;

inline constexpr std::string_view kPolicyKey = "policy";

/// Returns the sweep's keys with their values, and the policy where the campaign has some.
[[nodiscard]] CaseKeys KeysOf(const CampaignResults& results, const CampaignCase& of);

/// Returns "comms.comms_range=50, policy=A"; "all" without keys.
[[nodiscard]] std::string KeysText(const CaseKeys& keys);

/// Returns the values alone, "50 A", for a table that names the keys at its head: `max_characters`
/// at most, of a longer one the beginning and the case's id.
[[nodiscard]] std::string ShortLabel(const CampaignResults& results, const CampaignCase& of,
                                     size_t max_characters);

/// Returns the name of a trial, "<case id>-<repetition>".
[[nodiscard]] std::string TrialName(const CampaignResults& results, const TrialRow& row);

/// Returns the trial's value of a metric, kNoValue where it has none.
[[nodiscard]] double MetricOf(const TrialResult& result, size_t metric);

/// True where a value as a user writes it is the one that TOML writes so: by text, without quotes,
/// or as numbers.
[[nodiscard]] bool IsSameValue(std::string_view written, std::string_view toml);

/// Returns the number that TOML writes so; NaN: it is not one.
[[nodiscard]] double NumberOf(std::string_view toml);

}  // namespace shoal
