// All results of a campaign, in a fixed order: what reports, comparisons and exports are made from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/tools/campaign/campaign.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

/// A sweep point under a policy.
struct CampaignCase {
  std::string id;                   ///< 10 hexadecimal digits.
  std::vector<std::string> values;  ///< Of the sweep's keys, as TOML writes them.
  std::string policy;               ///< Empty: the campaign has none.
};

struct TrialRow {
  size_t case_number = 0;            ///< In CampaignResults::cases.
  int64_t repetition = 0;            ///< From 1.
  uint64_t seed = 0;                 ///< Of the mission.
  std::vector<std::string> samples;  ///< Of the sampled keys, as TOML writes them.
  TrialResult result;                ///< metrics has a value for each name, or kNoValue.
};

struct CampaignResults {
  Campaign campaign;
  std::vector<std::string> sweep_keys;    ///< In the order of the file.
  std::vector<std::string> sampled_keys;  ///< Likewise.
  std::vector<CampaignCase> cases;        ///< Sweep points in the order of the file, the last axis
                                          ///< fastest; of each point its policies.
  std::vector<MetricName> metrics;
  std::vector<TrialRow> rows;  ///< By case, then by repetition; each trial once.
  /// Finished trials beyond the look at which their case stopped: in no row.
  int64_t num_beyond_stop = 0;
};

}  // namespace shoal
