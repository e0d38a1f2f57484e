// Runs the mission of one trial of a campaign: in memory, or, where it needs processes of the
// user's, as `shoal run` does.
#pragma once

#include <string>

#include "lib/tools/trials/run_campaign.h"

namespace shoal {

/// Folders that processes of trials record into, removed with this.
class TrialScratch {
 public:
  TrialScratch();
  ~TrialScratch();
  TrialScratch(const TrialScratch&) = delete;
  TrialScratch& operator=(const TrialScratch&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Returns the outcome of a trial. `scratch` is used by missions that need processes, which run at
/// full speed on ports of their own.
[[nodiscard]] TrialResult RunCampaignTrial(const TrialInput& input, const std::string& scratch);

}  // namespace shoal
