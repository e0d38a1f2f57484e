#include "lib/tools/trials/submit.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "lib/bus/os/file_bytes.h"
#include "lib/bus/os/plain_folder.h"
#include "lib/tools/trials/trial_queue.h"

namespace shoal {

std::string ShellQuote(const std::string& text) {
  std::string quoted = "'";
  for (const char each : text) {
    if (each == '\'') {
      quoted += "'\\''";
    } else {
      quoted += each;
    }
  }
  return quoted + "'";
}

std::string ShardScriptText(const ShardScript& script) {
  std::string text = "#!/bin/sh\n";
  for (const std::string& directive : script.directives) text += "#SBATCH " + directive + "\n";
  text += fmt::format(
      "# Written by `shoal campaign submit`: runs one shard, whatever is missing of it.\n"
      "shard=${{1:-$SLURM_ARRAY_TASK_ID}}\n"
      "cd {} || exit 3\n"
      "# The trials under way finish; what is missing then is for the next submission.\n"
      "pid=\n"
      "trap '[ -z \"$pid\" ] || kill -TERM \"$pid\" 2> /dev/null' TERM INT HUP\n"
      "{} campaign run {} --out {} --shard \"$shard/{}\" --jobs {} --quiet &\n"
      "pid=$!\n"
      "wait \"$pid\"\n"
      "code=$?\n"
      "# A signal ends wait before its process has ended.\n"
      "while kill -0 \"$pid\" 2> /dev/null; do\n"
      "  wait \"$pid\"\n"
      "  code=$?\n"
      "done\n"
      "exit \"$code\"\n",
      ShellQuote(script.working_folder), ShellQuote(script.program),
      ShellQuote(script.campaign_file), ShellQuote(script.out), script.num_shards, script.num_jobs);
  return text;
}

std::map<int64_t, int64_t> MissingByShard(const CampaignFolder& folder, const StoredTrials& stored,
                                          int64_t num_shards) {
  std::map<int64_t, int64_t> missing;
  for (int64_t number = 1; number <= num_shards; ++number) {
    const TrialQueue queue(folder, {.number = number, .count = num_shards}, stored);
    const int64_t count = queue.num_planned() - queue.num_spared() - queue.num_finished();
    if (count > 0) missing[number] = count;
  }
  return missing;
}

std::string ArrayText(const std::vector<int64_t>& numbers) {
  std::string text;
  for (size_t i = 0; i < numbers.size();) {
    size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text += fmt::format("{}", numbers[i]);
    if (last > i) text += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return text;
}

std::vector<SlurmJob> ParseSlurmJobs(const std::string& text) {
  std::vector<SlurmJob> jobs;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    SlurmJob job;
    if (fields >> job.id >> job.num_shards && job.id > 0 && job.num_shards > 0) jobs.push_back(job);
  }
  return jobs;
}

std::string AppendSlurmJob(const std::string& path, const SlurmJob& job) {
  const std::filesystem::path file(path);
  const auto folder = PlainFolder::Open(file.parent_path().string());
  if (!folder.ok()) return folder.error();
  const Result<FileDescriptor> out = folder->OpenFile(file.filename().string(), O_APPEND);
  if (!out.ok()) return out.error();
  if (WriteAll(out->get(), fmt::format("{} {}\n", job.id, job.num_shards))) return {};
  return fmt::format("{}: cannot be written: is the disk full?", path);
}

std::optional<int64_t> ParseSubmittedJob(const std::string& output) {
  // Plugins of a site may print lines of their own before.
  std::optional<int64_t> found;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) {
    const std::string digits = line.substr(0, line.find(';'));
    const bool is_number = !digits.empty() && digits.size() < 19 &&
                           digits.find_first_not_of("0123456789") == std::string::npos;
    if (is_number) found = std::stoll(digits);
  }
  return found;
}

SlurmTasks ParseSlurmTasks(const std::string& output, const std::vector<SlurmJob>& jobs) {
  SlurmTasks tasks;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    int64_t id = 0;
    std::string state;
    std::string reason;
    if (!(fields >> id >> state)) continue;
    std::getline(fields >> std::ws, reason);
    const bool is_ours =
        std::any_of(jobs.begin(), jobs.end(), [id](const SlurmJob& job) { return job.id == id; });
    if (!is_ours) continue;
    const bool is_running = state == "RUNNING" || state == "COMPLETING" || state == "CONFIGURING" ||
                            state == "STOPPED" || state == "SIGNALING" || state == "STAGE_OUT";
    const bool is_waiting = state == "PENDING" || state == "SUSPENDED" ||
                            state.starts_with("REQUEUE") || state == "SPECIAL_EXIT" ||
                            state.starts_with("RESV") || state == "RESIZING";
    if (is_running) ++tasks.num_running;
    if (is_waiting && tasks.num_waiting++ == 0) tasks.reason = reason;
  }
  return tasks;
}

}  // namespace shoal
