#include "apps/shoal_campaign/campaign_submit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include "apps/shoal_campaign/campaign_setup.h"
#include "lib/bus/os/plain_folder.h"
#include "lib/bus/os/run_program.h"
#include "lib/bus/os/text_file.h"
#include "lib/run/command_line/find_program.h"
#include "lib/run/launch/child_processes.h"
#include "lib/run/run/run_app.h"
#include "lib/tools/report/report_tables.h"
#include "lib/tools/trials/campaign_progress.h"
#include "lib/tools/trials/reduce.h"
#include "lib/tools/trials/submit.h"
#include "lib/tools/trials/trial_queue.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

constexpr int64_t kDefaultShards = 4;
constexpr int kMaxIdleRounds = 3;    ///< Submissions in a row after which no trial was added.
constexpr int kMaxSilentPolls = 60;  ///< Of squeue that fails.
constexpr int64_t kPoll_us = 1'000'000;
constexpr int kNotExecuted = 127;
constexpr char kParallel[] = "parallel";

std::string MissingPackage(const std::string& program, const std::string& package) {
  return fmt::format(
      "{} is missing on this machine; it is in the package {}: sudo apt-get install "
      "--no-install-recommends {}",
      program, package, package);
}

/// Returns the shards that lack trials, in order.
std::vector<int64_t> ShardsOf(const std::map<int64_t, int64_t>& missing) {
  std::vector<int64_t> shards;
  shards.reserve(missing.size());
  for (const auto& [shard, count] : missing) shards.push_back(shard);
  return shards;
}

/// What runs shards: Slurm, or GNU parallel.
class ShardEngine {
 public:
  virtual ~ShardEngine() = default;
  /// Starts what lacks trials. Returns a problem, or an empty string.
  virtual std::string Submit(const std::vector<int64_t>& shards) = 0;
  /// Whether anything of it still runs or waits; nothing where that is not known now.
  virtual std::optional<bool> IsActive() = 0;
  /// Why IsActive() does not know.
  virtual std::string Trouble() const = 0;
  /// What is behind the line of progress.
  virtual std::string Note() const = 0;
  /// Ctrl-C: states, or does, what becomes of the shards.
  virtual void Leave() = 0;
  virtual std::string OutputPath(int64_t shard) const = 0;
};

class SlurmEngine : public ShardEngine {
 public:
  SlurmEngine(const CampaignSubmitOptions& options, fs::path folder, std::vector<SlurmJob> jobs,
              int64_t num_shards)
      : options_(options),
        folder_(std::move(folder)),
        jobs_(std::move(jobs)),
        num_shards_(num_shards) {}

  std::string Submit(const std::vector<int64_t>& shards) override {
    // In a file name of Slurm, %a is the array's index, and %% a percent sign.
    std::string output;
    for (const char each : folder_.string()) output += each == '%' ? "%%" : std::string(1, each);
    std::vector<std::string> argv = {"sbatch", "--parsable", "--array=" + ArrayText(shards),
                                     fmt::format("--output={}/%a.out", output)};
    argv.insert(argv.end(), options_.sbatch.begin(), options_.sbatch.end());
    argv.push_back((folder_ / "array.sh").string());
    const ProgramOutput ran = RunProgram(argv);
    if (ran.exit_code == kNotExecuted) return MissingPackage("sbatch", "slurm-client");
    const std::optional<int64_t> id = ParseSubmittedJob(ran.standard);
    if (ran.exit_code != 0 || !id) {
      return fmt::format("sbatch failed with exit code {}: {}{}", ran.exit_code, ran.errors,
                         ran.standard);
    }
    jobs_.push_back({.id = *id, .num_shards = num_shards_});
    Show("Slurm job {}: {} shards\n", *id, shards.size());
    std::fflush(stdout);
    return AppendSlurmJob((folder_ / "jobs").string(), jobs_.back());
  }

  std::optional<bool> IsActive() override {
    const ProgramOutput ran = RunProgram({"squeue", "--noheader", "--array", "--me", "--states=all",
                                          fmt::format("--format={}", kSlurmTaskFormat)});
    if (ran.exit_code != 0) {
      trouble_ = ran.exit_code == kNotExecuted ? MissingPackage("squeue", "slurm-client")
                                               : "squeue failed: " + ran.errors;
      return std::nullopt;
    }
    tasks_ = ParseSlurmTasks(ran.standard, jobs_);
    return !tasks_.empty();
  }

  std::string Note() const override {
    std::string note =
        fmt::format("  {} shards run, {} wait", tasks_.num_running, tasks_.num_waiting);
    if (!tasks_.reason.empty() && tasks_.reason != "None") note += " (" + tasks_.reason + ")";
    return note;
  }

  void Leave() override {
    std::vector<int64_t> ids;
    for (const SlurmJob& job : jobs_) ids.push_back(job.id);
    Show(
        "Slurm's jobs go on ({}). To follow them again: the same command. To cancel them: scancel "
        "{}\n",
        fmt::join(ids, ", "), fmt::join(ids, " "));
  }

  std::string OutputPath(int64_t shard) const override {
    return (folder_ / fmt::format("{}.out", shard)).string();
  }

  std::string Trouble() const override { return trouble_; }

 private:
  const CampaignSubmitOptions& options_;
  const fs::path folder_;
  std::vector<SlurmJob> jobs_;
  const int64_t num_shards_;
  SlurmTasks tasks_;
  std::string trouble_;
};

class ParallelEngine : public ShardEngine {
 public:
  ParallelEngine(const CampaignSubmitOptions& options, fs::path folder, double timeout_s)
      : options_(options), folder_(std::move(folder)), timeout_s_(timeout_s) {}

  std::string Submit(const std::vector<int64_t>& shards) override {
    // The trials under way may need their whole time to finish after TERM.
    const auto patience_ms = static_cast<int64_t>((timeout_s_ + 10) * 1000);
    std::vector<std::string> argv = {
        "/usr/bin/env", kParallel,
        "--will-cite",  "--plain",
        "--joblog",     (folder_ / "joblog").string(),
        "--termseq",    fmt::format("TERM,{},KILL", patience_ms),
        "--jobs",       fmt::format("{}%", std::max(1, 100 / options_.num_cpus))};
    if (!options_.hosts.empty()) argv.insert(argv.end(), {"--sshlogin", options_.hosts});
    if (!options_.login_file.empty()) {
      argv.insert(argv.end(), {"--sshloginfile", options_.login_file});
    }
    argv.insert(argv.end(), {"-I", "%SHARD%",
                             fmt::format("sh {} %SHARD% > {}/%SHARD%.out 2>&1",
                                         ShellQuote((folder_ / "array.sh").string()),
                                         ShellQuote(folder_.string())),
                             ":::"});
    for (const int64_t shard : shards) argv.push_back(std::to_string(shard));
    const Result<pid_t> started = children_.Start({.name = kParallel,
                                                   .argv = std::move(argv),
                                                   .environment = {},
                                                   .log_path = (folder_ / "output").string()});
    return started.ok() ? std::string() : started.error();
  }

  std::optional<bool> IsActive() override {
    static_cast<void>(children_.Reap());
    return children_.num_running() > 0;
  }

  std::string Trouble() const override { return {}; }
  std::string Note() const override { return "  GNU parallel"; }

  void Leave() override {
    Show("The trials under way finish. The same command goes on.\n");
    std::fflush(stdout);
    // The first TERM begins no other shard, the second is handed on to those that run.
    children_.Signal(kParallel, SIGTERM);
    usleep(kPoll_us / 5);
    children_.Signal(kParallel, SIGTERM);
    while (*IsActive()) usleep(kPoll_us / 10);
  }

  std::string OutputPath(int64_t shard) const override {
    return (folder_ / fmt::format("{}.out", shard)).string();
  }

 private:
  const CampaignSubmitOptions& options_;
  const fs::path folder_;
  const double timeout_s_;
  ChildProcesses children_;
};

int FailWith(const std::string& why, int code = kExitEnvironment) {
  ShowError("shoal: {}\n", why);
  return code;
}

OutcomeCounts CountsOf(const StoredTrials& stored) {
  OutcomeCounts counts;
  for (const auto& trials : stored.by_case) {
    for (const auto& [repetition, trial] : trials) {
      ++counts.of[static_cast<size_t>(trial.result.outcome)];
    }
  }
  return counts;
}

int64_t NumMissing(const TrialQueue& queue) {
  return queue.num_planned() - queue.num_spared() - queue.num_finished();
}

class Follower {
 public:
  Follower(const CampaignFolder& folder, ShardEngine* engine, int64_t num_shards, bool is_quiet)
      : folder_(folder), engine_(engine), num_shards_(num_shards), progress_(is_quiet) {}

  /// Returns nothing once no trial is missing, else an exit code.
  std::optional<int> Follow() {
    for (int num_silent = 0;;) {
      if (IsCampaignInterrupted()) {
        progress_.End();
        engine_->Leave();
        return kExitMissionFailed;
      }
      // The queue is asked first: what has left it has stored its trials before.
      const std::optional<bool> is_active = engine_->IsActive();
      num_silent = is_active ? 0 : num_silent + 1;
      if (num_silent >= kMaxSilentPolls) {
        progress_.End();
        engine_->Leave();
        return FailWith(engine_->Trouble());
      }
      const int64_t begin_us = MonotonicMicroseconds();
      const Result<StoredTrials> stored = ReadShards(folder_);
      if (!stored.ok()) return FailWith(stored.error());
      const TrialQueue whole(folder_, {}, *stored);
      Show(*stored, whole);
      if (is_active && !*is_active) {
        if (NumMissing(whole) <= 0) break;
        if (const auto code = SubmitMissing(*stored)) return code;
      }
      // A large folder takes long to read: a tenth of the time at most goes into it.
      const int64_t spent_us = MonotonicMicroseconds() - begin_us;
      usleep(static_cast<useconds_t>(std::max(kPoll_us, 9 * spent_us)));
    }
    progress_.End();
    return std::nullopt;
  }

 private:
  void Show(const StoredTrials& stored, const TrialQueue& queue) {
    const OutcomeCounts counts = CountsOf(stored);
    for (size_t i = 0; i < counts.of.size() && counts_; ++i) {
      for (int64_t n = counts_->of[i]; n < counts.of[i]; ++n) {
        progress_.Count(static_cast<TrialOutcome>(i));
      }
    }
    counts_ = counts;
    progress_.Show(queue.num_finished(), queue.num_planned() - queue.num_spared(),
                   MonotonicMicroseconds(), engine_->Note());
  }

  std::optional<int> SubmitMissing(const StoredTrials& stored) {
    num_idle_ = stored.size() > num_stored_ ? 0 : num_idle_ + 1;
    num_stored_ = stored.size();
    const std::map<int64_t, int64_t> missing = MissingByShard(folder_, stored, num_shards_);
    progress_.End();
    if (num_idle_ > kMaxIdleRounds) return GiveUp(missing);
    const std::string problem = engine_->Submit(ShardsOf(missing));
    if (!problem.empty()) return FailWith(problem);
    return std::nullopt;
  }

  int GiveUp(const std::map<int64_t, int64_t>& missing) const {
    constexpr size_t kLines = 5;
    constexpr int kMaxShown = 3;
    const std::vector<int64_t> shards = ShardsOf(missing);
    ShowError("shoal: {} submissions in a row added no trial; shards that lack some: {}\n",
              kMaxIdleRounds, ArrayText(shards));
    int num_shown = 0;
    for (const int64_t shard : shards) {
      if (num_shown++ == kMaxShown) break;
      const std::string path = engine_->OutputPath(shard);
      const std::vector<std::string> lines = LastLines(path, kLines);
      ShowError("{}: {}\n", path,
                lines.empty() ? "nothing was printed: is the folder on a file system of all nodes?"
                              : fmt::format("{}", fmt::join(lines, "\n  ")));
    }
    return kExitMissionFailed;
  }

  const CampaignFolder& folder_;
  ShardEngine* engine_;
  const int64_t num_shards_;
  CampaignProgress progress_;
  std::optional<OutcomeCounts> counts_;
  int64_t num_stored_ = -1;
  int num_idle_ = 0;
};

/// Returns jobs of the folder whose tasks are still in the queue.
Result<std::vector<SlurmJob>> ActiveJobs(const fs::path& folder) {
  std::vector<SlurmJob> active;
  const auto results = PlainFolder::Open(folder.parent_path().string());
  if (!results.ok()) return active;
  const auto slurm = results->Existing(folder.filename().string());
  if (!slurm.ok()) return active;
  const std::vector<SlurmJob> known = ParseSlurmJobs(slurm->ReadText("jobs").text);
  if (known.empty()) return active;
  const ProgramOutput ran = RunProgram({"squeue", "--noheader", "--array", "--me", "--states=all",
                                        fmt::format("--format={}", kSlurmTaskFormat)});
  if (ran.exit_code == kNotExecuted) return Error{MissingPackage("squeue", "slurm-client")};
  if (ran.exit_code != 0) return Error{"squeue failed: " + ran.errors};
  for (const SlurmJob& job : known) {
    if (!ParseSlurmTasks(ran.standard, {job}).empty()) active.push_back(job);
  }
  return active;
}

std::string WriteScript(const CampaignSubmitOptions& options, const fs::path& folder,
                        int64_t num_shards) {
  const Result<std::string> program = FindBeside("shoal");
  if (!program.ok()) return program.error();
  std::error_code error;
  const auto results = PlainFolder::Open(folder.parent_path().string());
  if (!results.ok()) return results.error();
  const auto own = results->Below(folder.filename().string());
  if (!own.ok()) return own.error();
  // Slurm, GNU parallel and the shell write there too, and follow links.
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!entry.is_symlink(error)) continue;
    return fmt::format("{}: is a link, and would be written through: remove it",
                       entry.path().string());
  }
  std::vector<std::string> directives;
  if (options.engine == CampaignSubmitOptions::Engine::kSlurm) {
    directives = {"--job-name=shoal", "--requeue", "--open-mode=append",
                  fmt::format("--cpus-per-task={}", options.num_cpus)};
    if (!options.partition.empty()) directives.push_back("--partition=" + options.partition);
    // A minute before the limit: the trials under way finish, and no other begins.
    if (!options.time.empty()) {
      directives.insert(directives.end(), {"--time=" + options.time, "--signal=B:TERM@60"});
    }
  }
  const std::string path = (folder / "array.sh").string();
  TextFile script(path, ShardScriptText({.program = *program,
                                         .working_folder = fs::current_path(error).string(),
                                         .campaign_file = options.file,
                                         .out = options.out,
                                         .num_shards = num_shards,
                                         .num_jobs = options.num_cpus,
                                         .directives = directives}));
  if (script.Flush()) return {};
  return fmt::format("{}: cannot be written: is the disk full, or the folder another user's?",
                     path);
}

}  // namespace

int RunCampaignSubmit(const CampaignSubmitOptions& options) {
  const bool is_slurm = options.engine == CampaignSubmitOptions::Engine::kSlurm;
  if (!is_slurm && !options.follows) {
    return FailWith("--no-follow is for Slurm: GNU parallel is a process of this command",
                    kExitUsage);
  }
  const std::string program = is_slurm ? "sbatch" : kParallel;
  if (RunProgram({program, "--version"}).exit_code == kNotExecuted) {
    return FailWith(MissingPackage(program, is_slurm ? "slurm-client" : "parallel"));
  }
  PreparedCampaign prepared;
  if (const auto code = PrepareCampaign(options.file, &prepared)) return *code;
  if (const std::string problem = MakeCampaignFolder(options.out); !problem.empty()) {
    return FailWith(problem);
  }
  const Result<CampaignFolder> folder =
      OpenCampaignFolder(options.out, prepared.loaded, prepared.made.plan);
  if (!folder.ok()) return FailWith(folder.error(), kExitUsage);
  CatchCampaignSignals();
  std::error_code error;
  const fs::path own = fs::absolute(options.out, error) / (is_slurm ? "slurm" : "parallel");
  int64_t num_shards = options.num_shards == 0 ? kDefaultShards : options.num_shards;
  std::vector<SlurmJob> active;
  if (is_slurm) {
    Result<std::vector<SlurmJob>> found = ActiveJobs(own);
    if (!found.ok()) return FailWith(found.error());
    active = *std::move(found);
  }
  if (!active.empty()) {
    num_shards = active.back().num_shards;
    Show("attached to Slurm job {} of {} shards, which is in the queue\n", active.back().id,
         num_shards);
    std::fflush(stdout);
  }
  if (active.empty()) {
    if (const std::string problem = WriteScript(options, own, num_shards); !problem.empty()) {
      return FailWith(problem);
    }
  }
  SlurmEngine slurm(options, own, active, num_shards);
  ParallelEngine parallel(options, own, folder->campaign.timeout_s);
  ShardEngine* engine = is_slurm ? static_cast<ShardEngine*>(&slurm) : &parallel;
  if (!options.follows) {
    if (!active.empty()) return kExitOk;
    const Result<StoredTrials> stored = ReadShards(*folder);
    if (!stored.ok()) return FailWith(stored.error());
    const std::vector<int64_t> shards = ShardsOf(MissingByShard(*folder, *stored, num_shards));
    const std::string problem = shards.empty() ? std::string() : engine->Submit(shards);
    return problem.empty() ? static_cast<int>(kExitOk) : FailWith(problem);
  }
  if (const auto code = Follower(*folder, engine, num_shards, options.quiet).Follow()) return *code;
  const Result<CampaignResults> results = ReduceCampaign(*folder);
  if (!results.ok()) return FailWith(results.error());
  Show("{}: {}\n", options.out, CountsText(*results));
  PrintTroubles(*results);
  return HasTroubles(*results) ? kExitMissionFailed : kExitOk;
}

}  // namespace shoal
