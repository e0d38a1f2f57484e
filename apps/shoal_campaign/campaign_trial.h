// Runs the mission of one trial of a campaign: in memory, or, where it needs processes of the
// user's, as `shoal run` does.
#pragma once

#include <string>

#include "lib/tools/trials/run_campaign.h"

namespace shoal {

/// Of the ScratchFolder that missions with processes record into.
inline constexpr char kTrialScratch[] = "shoal-trials";

/// Returns the outcome of a trial. `scratch` is used by missions that need processes, which run at
/// full speed on ports of their own.
[[nodiscard]] TrialResult RunCampaignTrial(const TrialInput& input, const std::string& scratch);

}  // namespace shoal
