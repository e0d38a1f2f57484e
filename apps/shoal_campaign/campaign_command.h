// `shoal campaign`: many trials of one mission. docs/campaigns/campaigns.md
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lib/tools/trials/run_campaign.h"

namespace shoal {

struct CampaignCheckOptions {
  std::string file;
  int num_jobs = 0;  ///< 0: as many as this machine has processors.
};

/// Prints everything that is wrong with a campaign file and its missions; else how many trials it
/// is, and about how long they take, which a few of them show.
int RunCampaignCheck(const CampaignCheckOptions& options);

struct CampaignRunCommand {
  std::string file;
  std::string out;
  CampaignRunOptions run;  ///< num_jobs 0: as many as this machine has processors.
};

/// Runs what is missing. kExitMissionFailed where trials are missing still, were errors or ran out
/// of time; a trial that failed is an answer.
int RunCampaignRun(const CampaignRunCommand& command);

/// Prints how far a folder is, in one line.
int RunCampaignStatus(const std::string& dir);

/// Writes results.csv and results.sqlite again.
int RunCampaignReduce(const std::string& dir);

struct CampaignReplayOptions {
  std::string dir;
  std::string trial;
  bool is_viewed = false;
  std::string out;  ///< Folder of the recording; empty: DIR/replays/TRIAL.
  bool allow_build = false;
};

/// Runs one trial again, with a recording, and shows it in the viewer where asked to.
int RunCampaignReplay(const CampaignReplayOptions& options);

}  // namespace shoal
