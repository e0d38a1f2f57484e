// A campaign as shards for a cluster: the script that runs one shard, what is missing of each, and
// the job ids that a folder remembers. docs/campaigns/cluster.md
//
//   DIR/slurm/array.sh        the script of a Slurm array: array index K is shard K of N
//   DIR/slurm/jobs            one line per submitted array: its id and N
//   DIR/slurm/K.out           what shard K printed
//   DIR/parallel/             the same for GNU parallel, and its joblog
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/tools/trials/campaign_folder.h"

namespace shoal {

/// Returns the text in single quotes, so that a POSIX shell reads exactly it.
[[nodiscard]] std::string ShellQuote(const std::string& text);

/// What each shard runs. Paths are those of every machine that runs one.
struct ShardScript {
  std::string program;         ///< Absolute path of `shoal`.
  std::string working_folder;  ///< In which `campaign_file` and `out` are looked for.
  std::string campaign_file;
  std::string out;
  int64_t num_shards = 1;
  int num_jobs = 1;                     ///< Trials at the same time, and CPUs of a Slurm task.
  std::vector<std::string> directives;  ///< Of sbatch, each without its "#SBATCH ".
};

/// Returns a script whose first argument, or SLURM_ARRAY_TASK_ID, is the shard. On TERM it lets the
/// trials under way finish.
[[nodiscard]] std::string ShardScriptText(const ShardScript& script);

/// Returns how many trials each of `num_shards` shards lacks; those that lack none are left out.
[[nodiscard]] std::map<int64_t, int64_t> MissingByShard(const CampaignFolder& folder,
                                                        const StoredTrials& stored,
                                                        int64_t num_shards);

/// Returns "1-4,7": numbers as sbatch --array takes them. @pre rising
[[nodiscard]] std::string ArrayText(const std::vector<int64_t>& numbers);

struct SlurmJob {
  int64_t id = 0;
  int64_t num_shards = 1;
  bool operator==(const SlurmJob&) const = default;
};

/// Returns the jobs of a text that AppendSlurmJob wrote; lines that are none are left out.
[[nodiscard]] std::vector<SlurmJob> ParseSlurmJobs(const std::string& text);
/// Appends a job. Returns why it could not be written, or an empty string.
[[nodiscard]] std::string AppendSlurmJob(const std::string& path, const SlurmJob& job);

/// Returns the id of what `sbatch --parsable` printed: "17" or "17;cluster".
[[nodiscard]] std::optional<int64_t> ParseSubmittedJob(const std::string& output);

/// Tasks of our own jobs in the queue.
struct SlurmTasks {
  int64_t num_running = 0;
  int64_t num_waiting = 0;
  std::string reason;  ///< Why the first of them waits, in Slurm's word.

  [[nodiscard]] bool empty() const { return num_running + num_waiting == 0; }
};

/// Format of squeue that ParseSlurmTasks reads.
inline constexpr char kSlurmTaskFormat[] = "%F %T %r";

/// Returns the tasks of `jobs` in what squeue printed.
[[nodiscard]] SlurmTasks ParseSlurmTasks(const std::string& output,
                                         const std::vector<SlurmJob>& jobs);

}  // namespace shoal
