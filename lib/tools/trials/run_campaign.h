// Runs the trials of a campaign that are missing, in worker processes, and stores each at once.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "lib/mission/model/mission.h"
#include "lib/tools/trials/campaign_folder.h"
#include "lib/tools/trials/trial_queue.h"
#include "lib/tools/trials/worker_pool.h"

namespace shoal {

/// How many of the trials that did not pass are run again with a recording.
struct KeepRule {
  static constexpr int64_t kAll = INT64_MAX;
  int64_t most = 10;
};

struct CampaignRunOptions {
  int num_jobs = 1;
  Shard shard;
  std::optional<double> max_time_s;  ///< Of wall time: then trials under way finish.
  KeepRule keep;
  bool again_errors = false;    ///< Trials that were errors are run once more.
  bool again_timeouts = false;  ///< Likewise those that ran out of time.
  bool quiet = false;           ///< No line of progress.
};

/// One trial, ready to run.
struct TrialInput {
  std::string name;  ///< "4f2a91c3e0-17".
  const Mission& mission;
  const std::vector<std::string>& overrides;  ///< That made `mission` of plan.mission_text.
  const Plan& plan;
  std::string record_dir;  ///< Empty: without a recording. Else a folder, replaced by one.
  double timeout_s = 60;   ///< Of wall time.
  TrialProgress* progress = nullptr;
};

/// Runs one trial's mission to its end.
using TrialRunner = std::function<TrialResult(const TrialInput&)>;

/// What a call of RunCampaign did.
struct CampaignRun {
  int64_t num_run = 0;
  int64_t num_finished = 0;  ///< Of this shard, those of earlier calls included.
  int64_t num_planned = 0;   ///< Of this shard, less those that a stop rule spared.
  int64_t num_recorded = 0;
  std::string problem;  ///< Why it could not go on (disk full); empty: it did not have to stop.
  std::vector<std::string> differing;  ///< Trials that gave another result when run again.
};

/// Runs what is missing of a shard. `interrupted` is asked often: once it is true, trials under way
/// finish, and no other begins.
[[nodiscard]] CampaignRun RunCampaign(const CampaignFolder& folder,
                                      const CampaignRunOptions& options, const TrialRunner& run,
                                      const std::function<bool()>& interrupted);

/// Runs one trial in this process. An error where its mission is wrong.
[[nodiscard]] TrialResult RunOneTrial(const CampaignFolder& folder, const TrialJob& job,
                                      const std::string& record_dir, const TrialRunner& run,
                                      TrialProgress* progress);

}  // namespace shoal
