// The folder of a campaign's results.
//
//   DIR/campaign.toml          the campaign file
//   DIR/campaign.json          build, identity, cases and metrics: what results are of
//   DIR/shards/K-of-N.jsonl    one line per finished trial
//   DIR/failures/TRIAL/        recordings of trials that did not pass
//   DIR/results.csv, .sqlite   made from the shards, at any time, the same bytes
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/tools/campaign/campaign.h"
#include "lib/tools/campaign/load_campaign.h"
#include "lib/tools/campaign/plan.h"
#include "lib/tools/campaign/results.h"
#include "lib/tools/trials/trial_line.h"

namespace shoal {

/// A folder that has been read: enough for reports, without the mission.
struct CampaignFolder {
  std::string path;
  Campaign campaign;
  Plan plan;  ///< Without mission_text.
};

/// Makes the folder where it is missing. Returns why it cannot be written, or an empty string.
[[nodiscard]] std::string MakeCampaignFolder(const std::string& path);

/// Makes the folder, or finds that it holds results of the same build, mission, seed, samples and
/// metrics: more repetitions, sweep points and policies may have come. The error names what
/// differs, and the remedy. Where it differs nothing is changed.
[[nodiscard]] Result<CampaignFolder> OpenCampaignFolder(const std::string& path,
                                                        const LoadedCampaign& loaded,
                                                        const Plan& plan);

/// Reads a folder that is there.
[[nodiscard]] Result<CampaignFolder> ReadCampaignFolder(const std::string& path);

/// Makes the folder of one trial, DIR/failures/TRIAL or DIR/replays/TRIAL, in place of what bears
/// its name, and returns `path`. An error where the folder that it lies in is a link: what that
/// leads to stays as it is.
[[nodiscard]] Result<std::string> NewTrialFolder(const std::string& path);

/// All finished trials of a folder.
struct StoredTrials {
  /// By case, in the plan's order, and repetition.
  std::vector<std::map<int64_t, FinishedTrial>> by_case;
  int64_t num_torn = 0;     ///< Lines that are not trials: their writer was killed.
  int64_t num_foreign = 0;  ///< Trials of cases that the plan has not.
  /// Trials of which two lines differ: shoal promises that there are none.
  std::vector<TrialKey> differing;
  /// Shards with trials of another arithmetic than the campaign's, and that arithmetic.
  std::map<std::string, std::string> of_other_arithmetic;

  [[nodiscard]] int64_t size() const;
};

/// Reads all shards. The error names a file that cannot be read.
[[nodiscard]] Result<StoredTrials> ReadShards(const CampaignFolder& folder);

/// Returns the trial that a text names: its case by as many digits as distinguish it. The error
/// lists what there is.
[[nodiscard]] Result<TrialKey> FindTrial(const CampaignFolder& folder, const std::string& text);

}  // namespace shoal
