#include "lib/tools/trials/run_campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <utility>

#include "lib/base/arithmetic/arithmetic_id.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/os/plain_folder.h"
#include "lib/bus/os/text_file.h"
#include "lib/mission/file/load.h"
#include "lib/run/run/run_app.h"
#include "lib/tools/trials/campaign_progress.h"
#include "lib/tools/trials/shard_file.h"

namespace shoal {

namespace {

constexpr int kWait_ms = 100;
constexpr int64_t kSyncInterval_us = 1'000'000;

/// True where a trial's result may be replaced by that of another attempt.
bool IsWantedAgain(const CampaignRunOptions& options, const FinishedTrial& trial) {
  return (options.again_errors && trial.result.outcome == TrialOutcome::kError) ||
         (options.again_timeouts && trial.result.outcome == TrialOutcome::kTimeout);
}

class CampaignRunner {
 public:
  CampaignRunner(const CampaignFolder& folder, const CampaignRunOptions& options,
                 const TrialRunner& run, const std::function<bool()>& interrupted)
      : folder_(folder),
        options_(options),
        run_(run),
        interrupted_(interrupted),
        progress_(options.quiet) {}

  CampaignRun Run() {
    Result<StoredTrials> stored = ReadShards(folder_);
    if (!stored.ok()) return {.problem = stored.error(), .differing = {}};
    const std::string path = fmt::format("{}/shards/{}-of-{}.jsonl", folder_.path,
                                         options_.shard.number, options_.shard.count);
    Result<ShardFile> shard = ShardFile::Open(path);
    if (!shard.ok()) return {.problem = shard.error(), .differing = {}};
    shard_ = &*shard;
    for (auto& trials : stored->by_case) {
      std::erase_if(trials, [&](const auto& entry) {
        const bool is_wanted = IsWantedAgain(options_, entry.second);
        if (is_wanted) attempts_[entry.second.key] = entry.second.attempt + 1;
        return is_wanted;
      });
    }
    TrialQueue queue(folder_, options_.shard, *stored);
    const int64_t num_missing = queue.num_planned() - queue.num_finished();
    const int most_jobs = static_cast<int>(
        std::clamp<int64_t>(num_missing, 1, static_cast<int64_t>(options_.num_jobs)));
    WorkerPool pool({.num_workers = most_jobs,
                     .timeout_s = folder_.campaign.timeout_s,
                     .metrics = folder_.plan.metrics,
                     .in_worker = [&shard] { shard->Abandon(); }},
                    [this](const TrialJob& job, TrialProgress* progress) {
                      return RunOneTrial(folder_, job, job.is_recorded ? FailurePath(job) : "",
                                         run_, progress);
                    });
    if (num_missing > 0) RunMissing(&queue, &pool);
    outcome_.num_finished = queue.num_finished();
    outcome_.num_planned = queue.num_planned() - queue.num_spared();
    if (outcome_.problem.empty() && !MustStop()) RecordFailures(&pool);
    progress_.End();
    if (const std::string problem = shard->Sync(); outcome_.problem.empty()) {
      outcome_.problem = problem;
    }
    return std::move(outcome_);
  }

 private:
  bool MustStop() {
    const int64_t now_us = MonotonicMicroseconds();
    return interrupted_() ||
           (options_.max_time_s && Seconds(now_us - begin_us_) >= *options_.max_time_s);
  }

  void RunMissing(TrialQueue* queue, WorkerPool* pool) {
    int64_t next_sync_us = begin_us_ + kSyncInterval_us;
    for (;;) {
      while (pool->HasIdle() && outcome_.problem.empty() && !MustStop()) {
        const auto job = queue->Next();
        if (!job) break;
        pool->Start(*job);
      }
      if (pool->num_busy() == 0) break;
      for (FinishedJob& done : pool->Wait(kWait_ms)) {
        Store(std::move(done), queue);
      }
      const int64_t now_us = MonotonicMicroseconds();
      if (now_us >= next_sync_us) {
        const std::string problem = shard_->Sync();
        if (outcome_.problem.empty()) outcome_.problem = problem;
        next_sync_us = now_us + kSyncInterval_us;
      }
      if (!pool->problem().empty() && pool->num_busy() == 0) outcome_.problem = pool->problem();
      progress_.Show(queue->num_finished(), queue->num_planned() - queue->num_spared(), now_us);
    }
  }

  TrialKey KeyOf(const TrialJob& job) const {
    return {folder_.plan.cases[job.case_number].id, job.repetition};
  }

  void Store(FinishedJob done, TrialQueue* queue) {
    FinishedTrial trial{.key = KeyOf(done.job),
                        .result = std::move(done.result),
                        .wall_s = done.wall_s,
                        .attempt = 0,
                        .arithmetic = ArithmeticId()};
    if (const auto attempt = attempts_.find(trial.key); attempt != attempts_.end()) {
      trial.attempt = attempt->second;
    }
    if (!outcome_.problem.empty()) return;  // Not stored, so not finished.
    const std::string problem = shard_->Append(TrialLine(trial, folder_.plan.metrics));
    if (!problem.empty()) {
      outcome_.problem = problem;
      return;
    }
    ++outcome_.num_run;
    progress_.Count(trial.result.outcome);
    queue->Finish(done.job, trial.result);
  }

  std::string FailurePath(const TrialJob& job) const {
    return fmt::format("{}/failures/{}", folder_.path, TrialName(KeyOf(job)));
  }

  /// True where the trial has been recorded in the folder itself; what a link leads to does not
  /// count.
  bool HasFailure(const TrialJob& job) const {
    const auto folder = PlainFolder::Open(folder_.path);
    if (!folder.ok()) return false;
    const auto failures = folder->Existing("failures");
    if (!failures.ok()) return false;
    const auto trial = failures->Existing(TrialName(KeyOf(job)));
    return trial.ok() && trial->FileToRead("why.txt").ok();
  }

  /// Runs trials that did not pass once more, with a recording: its log is what it would have been.
  void RecordFailures(WorkerPool* pool) {
    if (options_.keep.most <= 0) return;
    const Result<StoredTrials> stored = ReadShards(folder_);
    if (!stored.ok()) return;
    std::vector<std::pair<TrialJob, const FinishedTrial*>> wanted;
    for (size_t number = 0; number < stored->by_case.size(); ++number) {
      for (const auto& [repetition, trial] : stored->by_case[number]) {
        if (trial.result.outcome == TrialOutcome::kPass) continue;
        if (!options_.shard.Has(number, repetition)) continue;
        wanted.push_back(
            {{.case_number = number, .repetition = repetition, .is_recorded = true}, &trial});
      }
    }
    std::stable_sort(wanted.begin(), wanted.end(), [](const auto& a, const auto& b) {
      return a.first.repetition < b.first.repetition;
    });
    if (static_cast<int64_t>(wanted.size()) > options_.keep.most) {
      wanted.resize(static_cast<size_t>(options_.keep.most));
    }
    std::erase_if(wanted, [this](const auto& each) { return HasFailure(each.first); });
    if (wanted.empty()) return;
    if (const auto folder = PlainFolder::Open(folder_.path); folder.ok()) {
      if (const auto below = folder->Below("failures"); !below.ok()) {
        outcome_.problem = below.error();
        return;
      }
    }
    std::map<TrialKey, const FinishedTrial*> expected;
    for (const auto& [job, trial] : wanted) expected[trial->key] = trial;
    for (size_t next = 0; next < wanted.size() || pool->num_busy() > 0;) {
      while (next < wanted.size() && pool->HasIdle() && !MustStop()) {
        const TrialJob& job = wanted[next++].first;
        pool->Start(job);
      }
      if (MustStop()) next = wanted.size();
      for (const FinishedJob& done : pool->Wait(kWait_ms)) {
        WriteFailure(done, *expected.at(KeyOf(done.job)));
      }
    }
  }

  void WriteFailure(const FinishedJob& done, const FinishedTrial& stored) {
    const std::string path = FailurePath(done.job);
    const std::string name = TrialName(stored.key);
    if (done.result.outcome != stored.result.outcome) {
      outcome_.differing.push_back(
          fmt::format("{}: {} when it was run, {} when it was run again for its recording", name,
                      NameOf(stored.result.outcome), NameOf(done.result.outcome)));
    }
    std::error_code error;
    // A wrong mission was not recorded.
    if (!std::filesystem::is_directory(std::filesystem::symlink_status(path, error))) {
      if (!NewTrialFolder(path).ok()) return;
    }
    std::ostringstream out;
    out << NameOf(stored.result.outcome) << ": " << stored.result.why
        << "\n\nshoal campaign replay " << folder_.path << ' ' << name << '\n'
        << "shoal sim " << folder_.campaign.mission_file;
    for (const std::string& text :
         OverridesOf(folder_.campaign, folder_.plan, done.job.case_number, done.job.repetition)) {
      out << " --set '" << text << '\'';
    }
    out << '\n';
    if (TextFile(path + "/why.txt", out.str()).Flush()) ++outcome_.num_recorded;
  }

  const CampaignFolder& folder_;
  const CampaignRunOptions& options_;
  const TrialRunner& run_;
  const std::function<bool()>& interrupted_;
  CampaignProgress progress_;
  const int64_t begin_us_ = MonotonicMicroseconds();
  ShardFile* shard_ = nullptr;
  std::map<TrialKey, int64_t> attempts_;  ///< Of trials that are run again.
  CampaignRun outcome_;
};

}  // namespace

TrialResult RunOneTrial(const CampaignFolder& folder, const TrialJob& job,
                        const std::string& record_dir, const TrialRunner& run,
                        TrialProgress* progress) {
  const std::vector<std::string> overrides =
      OverridesOf(folder.campaign, folder.plan, job.case_number, job.repetition);
  const LoadedMission loaded =
      LoadMissionText(folder.plan.mission_text, folder.campaign.mission_file, overrides);
  if (!loaded.errors.empty()) {
    return {.outcome = TrialOutcome::kError,
            .why = fmt::format("{}", fmt::join(loaded.errors, "; ")),
            .metrics = {}};
  }
  progress->duration = Microseconds(loaded.mission.duration_s);
  return run({.name = TrialName({folder.plan.cases[job.case_number].id, job.repetition}),
              .mission = loaded.mission,
              .overrides = overrides,
              .plan = folder.plan,
              .record_dir = record_dir,
              .timeout_s = folder.campaign.timeout_s,
              .progress = progress});
}

CampaignRun RunCampaign(const CampaignFolder& folder, const CampaignRunOptions& options,
                        const TrialRunner& run, const std::function<bool()>& interrupted) {
  return CampaignRunner(folder, options, run, interrupted).Run();
}

}  // namespace shoal
