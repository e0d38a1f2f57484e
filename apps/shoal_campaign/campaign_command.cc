#include "apps/shoal_campaign/campaign_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <thread>
#include <utility>

#include "apps/shoal_campaign/campaign_setup.h"
#include "apps/shoal_campaign/campaign_trial.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/os/scratch_folder.h"
#include "lib/mission/file/print_errors.h"
#include "lib/run/command_line/build_id.h"
#include "lib/run/launch/launcher.h"
#include "lib/run/launch/recording.h"
#include "lib/run/launch/run_viewer.h"
#include "lib/run/run/run_app.h"
#include "lib/tools/trials/campaign_progress.h"
#include "lib/tools/trials/reduce.h"
#include "sim/app_factory.h"
#include "sim/run_sim.h"
#include "sim/simulation.h"

namespace shoal {

namespace {

constexpr int kMaxJobs = 1024;
constexpr int64_t kMaxMeasured = 4;  ///< Trials, by `check`.

int JobsOf(int wanted) {
  if (wanted > 0) return wanted;
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(processors, 1, kMaxJobs);
}

/// What `run` and `replay` start beside shoal's own processes, for the user to see.
void ShowPrograms(const std::vector<std::string>& programs) {
  constexpr size_t kMaxShown = 10;
  if (programs.empty()) return;
  Show("with your rights, the trials run or open:\n");
  for (size_t i = 0; i < std::min(kMaxShown, programs.size()); ++i) {
    Show("  {}\n", TerminalLine(programs[i]));
  }
  if (programs.size() > kMaxShown) Show("  ... {} more\n", programs.size() - kMaxShown);
  std::fflush(stdout);
}

/// Runs a trial that needs no process. A check starts none, whatever the mission's samples are.
TrialResult MeasureTrial(const TrialInput& input) {
  const auto can = CanRunInOneProcess(input.mission);
  if (can.ok()) return RunCampaignTrial(input, "");
  return {.outcome = TrialOutcome::kError, .why = can.error(), .metrics = {}};
}

/// Returns why trials are not timed: one of those that would be needs processes. Empty: none does.
std::string WhyNotTimed(const CampaignFolder& folder) {
  for (size_t i = 0; i < std::min<size_t>(kMaxMeasured, folder.plan.cases.size()); ++i) {
    const LoadedMission loaded =
        LoadMissionText(folder.plan.mission_text, folder.campaign.mission_file,
                        OverridesOf(folder.campaign, folder.plan, i, 1));
    const auto can = CanRunInOneProcess(loaded.mission);
    if (!can.ok()) return can.error();
  }
  return {};
}

/// Runs the first repetition of a few cases; returns the mean wall time of a trial, or 0.
double MeasureTrials(const CampaignFolder& folder) {
  constexpr double kLongest_s = 3;
  const auto most = std::min(
      kMaxMeasured, static_cast<int64_t>(folder.plan.cases.size()) * folder.campaign.repetitions);
  WorkerPool pool(
      {.num_workers = 1, .timeout_s = folder.campaign.timeout_s, .metrics = folder.plan.metrics},
      [&](const TrialJob& job, TrialProgress* progress) {
        return RunOneTrial(folder, job, "", MeasureTrial, progress);
      });
  double total_s = 0;
  int64_t count = 0;
  while (count < most && total_s < kLongest_s) {
    const size_t number = static_cast<size_t>(count) % folder.plan.cases.size();
    const int64_t round = count / static_cast<int64_t>(folder.plan.cases.size());
    pool.Start({.case_number = number, .repetition = round + 1});
    std::vector<FinishedJob> done;
    while (done.empty() && !IsCampaignInterrupted()) done = pool.Wait(100);
    if (done.empty()) break;
    total_s += done.front().wall_s;
    ++count;
  }
  return count == 0 ? 0 : total_s / static_cast<double>(count);
}

}  // namespace

int RunCampaignCheck(const CampaignCheckOptions& options) {
  PreparedCampaign prepared;
  if (const auto code = PrepareCampaign(options.file, &prepared)) return *code;
  const Campaign& campaign = prepared.loaded.campaign;
  const Plan& plan = prepared.made.plan;
  const auto num_cases = static_cast<int64_t>(plan.cases.size());
  const int64_t num_trials = num_cases * campaign.repetitions;
  Show("{} trials: {} case{} of {} repetitions each{}\n", num_trials, num_cases,
       num_cases == 1 ? "" : "s", campaign.repetitions,
       campaign.stop ? ", or fewer by [stop]" : "");
  constexpr size_t kMaxShown = 10;
  for (size_t i = 0; i < std::min(kMaxShown, plan.cases.size()); ++i) {
    Show("  {}  {}\n", plan.cases[i].id, CaseText(campaign, plan.cases[i]));
  }
  if (plan.cases.size() > kMaxShown) Show("  ... {} more\n", plan.cases.size() - kMaxShown);
  for (const SampledKey& key : campaign.samples) Show("sampled: {}\n", key.key);
  for (const MetricName& metric : plan.metrics) {
    Show("metric {}{}: {}\n", metric.name, metric.unit.empty() ? "" : " [" + metric.unit + "]",
         metric.text);
  }
  if (!prepared.made.bad_cases.empty()) {
    ShowError("{}: {} of {} cases are wrong, see above: their trials would be errors\n",
              options.file, prepared.made.bad_cases.size(), num_cases);
    return kExitUsage;
  }
  std::fflush(stdout);
  CatchCampaignSignals();
  const CampaignFolder folder{.path = {}, .campaign = campaign, .plan = plan};
  for (const std::string& each : prepared.made.programs)
    Show("runs or opens {}\n", TerminalLine(each));
  if (const std::string why = WhyNotTimed(folder); !why.empty()) {
    Show("not timed, since a check starts no process of a mission: {}\n", why);
    return kExitOk;
  }
  const double trial_s = MeasureTrials(folder);
  const int jobs = JobsOf(options.num_jobs);
  Show("about {} with {} job{} ({:.3g} s for a trial, by the first ones)\n",
       DurationText(trial_s * static_cast<double>(num_trials) / jobs), jobs, jobs == 1 ? "" : "s",
       trial_s);
  return kExitOk;
}

int RunCampaignRun(const CampaignRunCommand& command) {
  PreparedCampaign prepared;
  if (const auto code = PrepareCampaign(command.file, &prepared)) return *code;
  if (!prepared.made.bad_cases.empty()) {
    ShowError("{}: the trials of {} case(s) above will be errors\n", command.file,
              prepared.made.bad_cases.size());
  }
  if (const std::string problem = MakeCampaignFolder(command.out); !problem.empty()) {
    ShowError("shoal: {}\n", problem);
    return kExitEnvironment;
  }
  Result<CampaignFolder> folder =
      OpenCampaignFolder(command.out, prepared.loaded, prepared.made.plan);
  if (!folder.ok()) {
    ShowError("shoal: {}\n", folder.error());
    return kExitUsage;
  }
  CatchCampaignSignals();
  ShowPrograms(prepared.made.programs);
  CampaignRunOptions options = command.run;
  options.num_jobs = JobsOf(options.num_jobs);
  const ScratchFolder scratch(kTrialScratch);
  const int64_t begin_us = MonotonicMicroseconds();
  const CampaignRun run = RunCampaign(
      *folder, options,
      [&scratch](const TrialInput& input) { return RunCampaignTrial(input, scratch.path()); },
      IsCampaignInterrupted);
  const double wall_s = Seconds(MonotonicMicroseconds() - begin_us);
  for (const std::string& text : run.differing) {
    ShowError("shoal: not reproducible: {}\n", text);
  }
  if (!run.problem.empty()) {
    ShowError("shoal: {}\n", run.problem);
    return kExitEnvironment;
  }
  const Result<CampaignResults> results = ReduceCampaign(*folder);
  if (!results.ok()) {
    ShowError("shoal: {}\n", results.error());
    return kExitEnvironment;
  }
  Show("{} trials in {} ({:.3g} per s){}\n", run.num_run, DurationText(wall_s),
       static_cast<double>(run.num_run) / std::max(wall_s, 1e-3),
       run.num_recorded == 0
           ? ""
           : fmt::format("; {} recorded in {}/failures", run.num_recorded, command.out));
  Show("{}: {}\n", command.out, CountsText(*results));
  PrintTroubles(*results);
  const bool is_complete = run.num_finished >= run.num_planned;
  if (!is_complete) {
    ShowError("shoal: {} of {} trials of shard {}/{} are missing; the same command goes on\n",
              run.num_planned - run.num_finished, run.num_planned, options.shard.number,
              options.shard.count);
  }
  return is_complete && !HasTroubles(*results) && run.differing.empty() ? kExitOk
                                                                        : kExitMissionFailed;
}

int RunCampaignStatus(const std::string& dir) {
  const Result<CampaignFolder> folder = ReadCampaignFolder(dir);
  if (!folder.ok()) {
    ShowError("shoal: {}\n", folder.error());
    return kExitUsage;
  }
  const Result<StoredTrials> stored = ReadShards(*folder);
  if (!stored.ok()) {
    ShowError("shoal: {}\n", stored.error());
    return kExitEnvironment;
  }
  const TrialQueue queue(*folder, {}, *stored);
  const CampaignResults results = ResultsOf(*folder, *stored);
  Show("{}: {}, {} missing\n", dir, CountsText(results),
       queue.num_planned() - queue.num_spared() - queue.num_finished());
  return kExitOk;
}

int RunCampaignReduce(const std::string& dir) {
  const Result<CampaignFolder> folder = ReadCampaignFolder(dir);
  if (!folder.ok()) {
    ShowError("shoal: {}\n", folder.error());
    return kExitUsage;
  }
  const Result<CampaignResults> results = ReduceCampaign(*folder);
  if (!results.ok()) {
    ShowError("shoal: {}\n", results.error());
    return kExitEnvironment;
  }
  Show("{}: {}\n{}/results.csv\n{}/results.sqlite\n", dir, CountsText(*results), dir, dir);
  return kExitOk;
}

int RunCampaignReplay(const CampaignReplayOptions& options) {
  const Result<CampaignFolder> folder = ReadCampaignFolder(options.dir);
  if (!folder.ok()) {
    ShowError("shoal: {}\n", folder.error());
    return kExitUsage;
  }
  const Result<TrialKey> key = FindTrial(*folder, options.trial);
  if (!key.ok()) {
    ShowError("shoal: {}: {}\n", options.dir, key.error());
    return kExitUsage;
  }
  const std::string build = BuildId();
  if (folder->plan.build != build && !options.allow_build) {
    ShowError(
        "shoal: {} was run with another build ({}; this one is {}): the trial may go another "
        "way; --allow-build runs it all the same\n",
        options.dir, TerminalLine(folder->plan.build), build);
    return kExitUsage;
  }
  const MadePlan made = MakePlan(folder->campaign, folder->plan.build);
  const auto& cases = folder->plan.cases;
  const auto number =
      static_cast<size_t>(std::find_if(cases.begin(), cases.end(),
                                       [&](const auto& each) { return each.id == key->case_id; }) -
                          cases.begin());
  if (number >= made.plan.cases.size() || made.plan.cases[number].id != key->case_id) {
    PrintErrors(made.errors);
    ShowError("shoal: the mission {} is not what it was when {} was run\n",
              TerminalLine(folder->campaign.mission_file), options.dir);
    return kExitUsage;
  }
  const std::vector<std::string> overrides =
      OverridesOf(folder->campaign, folder->plan, number, key->repetition);
  // As MakePlan has read it: the file that the folder names may be a pipe by now.
  const LoadedMission loaded =
      LoadMissionText(made.plan.mission_text, folder->campaign.mission_file, overrides);
  if (!LoadedWithoutErrors(loaded)) return kExitUsage;
  const std::string record_dir = options.out.empty()
                                     ? fmt::format("{}/replays/{}", options.dir, TrialName(*key))
                                     : options.out;
  if (options.out.empty()) {
    if (const auto folder_of_trial = NewTrialFolder(record_dir); !folder_of_trial.ok()) {
      ShowError("shoal: {}\n", folder_of_trial.error());
      return kExitUsage;
    }
  } else {
    std::error_code error;
    std::filesystem::create_directories(std::filesystem::path(record_dir).parent_path(), error);
  }
  Show("{} {}, seed {}\n", TrialName(*key), CaseText(folder->campaign, cases[number]),
       loaded.mission.seed);
  std::fflush(stdout);
  ShowPrograms(ProgramsOf(loaded.mission));
  const RunOptions run{.mission_file = folder->campaign.mission_file,
                       .overrides = overrides,
                       .warp = 0,
                       .layout = {},
                       .record_dir = record_dir,
                       .view = {}};
  int code = kExitOk;
  if (CanRunInOneProcess(loaded.mission).ok()) {
    if (const auto prepared = PrepareRecording(run, loaded.mission); !prepared.ok()) {
      ShowError("shoal: {}\n", prepared.error());
      return kExitEnvironment;
    }
    code = RunSim({.mission_file = run.mission_file,
                   .overrides = overrides,
                   .log_path = record_dir + "/mission.lcm"});
  } else {
    code = RunMission(run, loaded.mission, AppsToLaunch());
  }
  if (!options.is_viewed || code == kExitUsage || code == kExitEnvironment) return code;
  std::fflush(stdout);
  return RunView({.log = record_dir});
}

}  // namespace shoal
