// From the shards of a folder to results in a fixed order, and to files of them: the same bytes
// whatever ran the trials, in whatever order.
#pragma once

#include <string>

#include "lib/base/check/result.h"
#include "lib/tools/campaign/results.h"
#include "lib/tools/trials/campaign_folder.h"

namespace shoal {

/// Returns the rows of all finished trials; those beyond the look at which their case stopped are
/// left out and counted. Seeds and samples follow from the campaign.
[[nodiscard]] CampaignResults ResultsOf(const CampaignFolder& folder, const StoredTrials& stored);

/// Returns results.csv: case, swept keys, policy, repetition, seed, sampled keys, outcome, why, and
/// the metrics; values as TOML and C write them, an empty cell for a value that is not there.
[[nodiscard]] std::string ResultsCsv(const CampaignResults& results);

/// Writes results.sqlite in place of the one that is there: the tables trials (as results.csv),
/// cases and metrics. Returns why it could not be written, or an empty string.
[[nodiscard]] std::string WriteResultsSqlite(const CampaignResults& results,
                                             const std::string& path);

/// Reads the shards; writes nothing, so that a folder of another user can be looked at. The error
/// names a file that cannot be read, or a trial with two different results.
[[nodiscard]] Result<CampaignResults> ReadResults(const CampaignFolder& folder);

/// Reads the shards and writes results.csv and results.sqlite. Returns the results.
[[nodiscard]] Result<CampaignResults> ReduceCampaign(const CampaignFolder& folder);

}  // namespace shoal
