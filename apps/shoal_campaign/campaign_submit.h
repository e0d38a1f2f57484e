// `shoal campaign submit`: the shards of a campaign as a Slurm array, or by GNU parallel.
// docs/campaigns/cluster.md
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace shoal {

struct CampaignSubmitOptions {
  enum class Engine { kSlurm, kParallel };
  std::string file;
  std::string out;
  Engine engine = Engine::kSlurm;
  int64_t num_shards = 0;  ///< 0: as the folder's running jobs have, else 4.
  int num_cpus = 1;        ///< Trials at the same time within a shard.
  bool follows = true;
  bool quiet = false;
  std::string partition;                 ///< Of Slurm; empty: its default.
  std::string time;                      ///< Of Slurm; empty: the partition's limit.
  std::vector<std::string> sbatch = {};  ///< More arguments of sbatch.
  std::string hosts;                     ///< Of GNU parallel: "a,b"; empty: this machine.
  std::string login_file;                ///< Likewise, its --sshloginfile.
};

/// Submits the shards that lack trials, or attaches to jobs of the folder that still run; follows
/// them, submits again what is missing when they have ended, and reduces. Exit codes as
/// RunCampaignRun; Ctrl-C leaves Slurm's jobs running.
int RunCampaignSubmit(const CampaignSubmitOptions& options);

}  // namespace shoal
