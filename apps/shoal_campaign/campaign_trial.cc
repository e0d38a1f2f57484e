#include "apps/shoal_campaign/campaign_trial.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>

#include "lib/bus/os/read_file.h"
#include "lib/run/command_line/find_program.h"
#include "lib/run/launch/child_processes.h"
#include "lib/run/launch/recording.h"
#include "lib/run/run/run_app.h"
#include "sim/judge_log.h"
#include "sim/run_trial.h"
#include "sim/simulation.h"

namespace shoal {

namespace {

TrialResult ErrorBecause(std::string why) {
  return {.outcome = TrialOutcome::kError, .why = std::move(why), .metrics = {}};
}

/// Makes an empty folder with the mission file and what changes it, as `shoal run --record` does.
std::string PrepareTrial(const TrialInput& input) {
  if (const auto made = NewTrialFolder(input.record_dir); !made.ok()) return made.error();
  const RunOptions options{.mission_file = input.mission.file,
                           .overrides = input.overrides,
                           .layout = {},
                           .record_dir = input.record_dir,
                           .view = {}};
  const Result<bool> prepared = PrepareRecording(options, input.mission);
  return prepared.ok() ? std::string() : prepared.error();
}

TrialResult RunInMemory(const TrialInput& input) {
  std::string log_path;
  if (!input.record_dir.empty()) {
    if (std::string problem = PrepareTrial(input); !problem.empty()) return ErrorBecause(problem);
    log_path = input.record_dir + "/mission.lcm";
  }
  const int64_t tick_us = input.mission.tick_us;
  return RunTrial(
      input.mission, input.plan.metric_specs,
      [&](int64_t step) { input.progress->utime = step * tick_us; }, log_path);
}

/// Returns why the launcher ended the mission: what it lost, or else its last words, without what
/// differs from run to run, so that results of the same trial are the same.
std::string ReasonOf(const ChildExit& exit) {
  std::vector<std::string> reasons;
  for (const std::string& line : exit.last_lines) {
    if (line.starts_with("LOST") || line.starts_with("shoal:")) reasons.push_back(line);
  }
  if (reasons.empty() && !exit.last_lines.empty()) reasons.push_back(exit.last_lines.back());
  std::string text = fmt::format("{}", fmt::join(reasons, "; "));
  for (size_t at = 0; (at = text.find(" (pid ", at)) != std::string::npos;) {
    text.erase(at, text.find(')', at) + 1 - at);
  }
  return text;
}

TrialResult RunInProcesses(const TrialInput& input, const std::string& scratch) {
  const FileText file = ReadRegularFile(input.mission.file);
  if (file.text != input.plan.mission_text) {
    return ErrorBecause(fmt::format("{} has changed since the campaign began", input.mission.file));
  }
  if (scratch.empty()) {
    return ErrorBecause("no folder for temporary files can be made: is $TMPDIR there, and yours?");
  }
  const std::string folder = fmt::format("{}/{}", scratch, input.name);
  const std::string record_dir = input.record_dir.empty() ? folder + "/record" : input.record_dir;
  std::error_code error;
  for (const std::string& each : {folder, record_dir}) {
    if (const auto made = NewTrialFolder(each); !made.ok()) return ErrorBecause(made.error());
  }
  const Result<std::string> program = FindBeside("shoal");
  if (!program.ok()) return ErrorBecause(program.error());
  std::vector<std::string> argv = {*program, "run",     input.mission.file, "--warp",
                                   "max",    "--quiet", "--record",         record_dir};
  for (const std::string& text : input.overrides) {
    argv.emplace_back("--set");
    argv.push_back(text);
  }
  ChildProcesses children;
  const Result<pid_t> started = children.Start({.name = "shoal",
                                                .argv = std::move(argv),
                                                .environment = {},
                                                .log_path = folder + "/output.txt"});
  if (!started.ok()) return ErrorBecause(started.error());
  // The launcher is asked to end, and leaves no process behind; a kill of this one might.
  input.progress->ends_itself = true;
  const int64_t begin_us = MonotonicMicroseconds();
  const auto limit_us = static_cast<int64_t>(input.timeout_s * 1e6);
  bool is_late = false;
  std::vector<ChildExit> exits;
  while ((exits = children.Reap()).empty()) {
    constexpr useconds_t kLook_us = 5'000;  // A mission of processes takes seconds.
    usleep(kLook_us);
    if (is_late || MonotonicMicroseconds() - begin_us <= limit_us) continue;
    is_late = true;
    children.SignalAll(SIGTERM);
  }
  if (is_late) {
    std::filesystem::remove_all(folder, error);
    return {.outcome = TrialOutcome::kTimeout, .why = TimeoutText(input.timeout_s), .metrics = {}};
  }
  const ChildExit& exit = exits.front();
  const bool has_failed = exit.how.ends_with("code 1");
  TrialResult result;
  if (exit.clean || has_failed) {
    result = JudgeLog(input.mission, input.plan.metric_specs, record_dir + "/mission.lcm");
    // What the launcher knows and the log does not: an end before its time.
    if (has_failed && result.outcome == TrialOutcome::kPass) {
      result = ErrorBecause("shoal run failed: " + ReasonOf(exit));
    }
  } else {
    result = ErrorBecause(fmt::format("shoal run {}: {}", exit.how, ReasonOf(exit)));
  }
  std::filesystem::remove_all(folder, error);
  return result;
}

}  // namespace

TrialResult RunCampaignTrial(const TrialInput& input, const std::string& scratch) {
  const auto can = CanRunInOneProcess(input.mission);
  return can.ok() ? RunInMemory(input) : RunInProcesses(input, scratch);
}

}  // namespace shoal
