#include "apps/shoal_campaign/campaign_options.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

#include "apps/shoal_campaign/campaign_answers.h"
#include "apps/shoal_campaign/campaign_command.h"
#include "apps/shoal_campaign/campaign_submit.h"
#include "lib/run/command_line/tool_commands.h"

namespace shoal {

namespace {

constexpr int64_t kMaxShards = 100'000;
constexpr int kMaxCampaignJobs = 1024;

/// "K/N", with 1 <= K <= N.
std::optional<Shard> ParseShard(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(number.ptr + 1, end, shard.count);
  if (count.ec != std::errc() || count.ptr != end) return std::nullopt;
  if (shard.number < 1 || shard.count < shard.number || shard.count > kMaxShards) {
    return std::nullopt;
  }
  return shard;
}

/// "90", "90s", "15m", "2h": in seconds.
std::optional<double> ParseDuration(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const std::string unit(end);
  if (text.empty() || !(number > 0)) return std::nullopt;
  if (unit.empty() || unit == "s") return number;
  if (unit == "m" || unit == "min") return number * 60;
  if (unit == "h") return number * 3600;
  return std::nullopt;
}

std::optional<int64_t> ParseKeep(const std::string& text) {
  if (text == "failures") return KeepRule::kAll;
  if (text == "none") return 0;
  int64_t count = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, count);
  if (parsed.ec != std::errc() || parsed.ptr != end || count < 0) return std::nullopt;
  return count;
}

Option AddJobs(Command command, int* jobs) {
  return command
      .AddOption("--jobs,-j", jobs, "Trials at the same time; default: one for each processor")
      .InRange(1, kMaxCampaignJobs);
}

Option AddFolder(Command command, std::string* dir) {
  return command.AddOption("DIR", dir, "The folder that `run --out` made").Required();
}

void AddCampaignCheck(Command campaign, CommandAction* action) {
  const Command command = campaign.AddSubcommand(
      "check", "Show all that is wrong with a campaign file; how many trials, and how long");
  auto options = std::make_shared<CampaignCheckOptions>();
  command.AddOption("FILE", &options->file, "Campaign file").Required();
  AddJobs(command, &options->num_jobs);
  command.Callback(
      [options, action] { *action = [options] { return RunCampaignCheck(*options); }; });
}

void AddCampaignRun(Command campaign, CommandAction* action) {
  const Command command =
      campaign.AddSubcommand("run", "Run the trials that are missing, and reduce the results");
  struct Parsed {
    CampaignRunCommand command;
    std::string shard = "1/1";
    std::string max_time;
    std::string keep = "10";
    bool again = false;
  };
  auto parsed = std::make_shared<Parsed>();
  command.AddOption("FILE", &parsed->command.file, "Campaign file").Required();
  command
      .AddOption("--out", &parsed->command.out, "Folder of the results; made where it is missing")
      .Required();
  parsed->command.run.num_jobs = 0;
  AddJobs(command, &parsed->command.run.num_jobs);
  command.AddOption("--shard", &parsed->shard, "K/N: only the K-th of N parts")
      .Check([](const std::string& text) -> std::string {
        if (ParseShard(text)) return "";
        return fmt::format("'{}' is not K/N with K from 1 to N, such as 2/4", text);
      });
  command.AddOption("--max-time", &parsed->max_time, "Begin no trial after this time: 90s, 15m, 2h")
      .Check([](const std::string& text) -> std::string {
        if (ParseDuration(text)) return "";
        return fmt::format("'{}' is not a time such as 90s, 15m or 2h", text);
      });
  command
      .AddOption("--keep", &parsed->keep,
                 "Record trials that did not pass: failures (all), none, or the first N; default: "
                 "10")
      .Check([](const std::string& text) -> std::string {
        if (ParseKeep(text)) return "";
        return fmt::format("'{}' is neither failures nor none nor a number", text);
      });
  command.AddFlag("--again", &parsed->again, "Run errors and timeouts of earlier calls once more");
  command.AddFlag("--quiet", &parsed->command.run.quiet, "No line of progress");
  command.Callback([parsed, action] {
    *action = [parsed] {
      CampaignRunOptions& run = parsed->command.run;
      run.shard = *ParseShard(parsed->shard);
      run.keep.most = *ParseKeep(parsed->keep);
      if (!parsed->max_time.empty()) run.max_time_s = ParseDuration(parsed->max_time);
      run.again_errors = run.again_timeouts = parsed->again;
      return RunCampaignRun(parsed->command);
    };
  });
}

void AddCampaignSubmit(Command campaign, CommandAction* action) {
  const Command command = campaign.AddSubcommand(
      "submit", "Run the trials that are missing on a cluster, and reduce the results");
  struct Parsed {
    CampaignSubmitOptions options;
    std::string engine;
    std::string sbatch;
    bool no_follow = false;
  };
  auto parsed = std::make_shared<Parsed>();
  CampaignSubmitOptions& options = parsed->options;
  command.AddOption("FILE", &options.file, "Campaign file").Required();
  command.AddOption("--out", &options.out, "Folder of the results, on a file system of all nodes")
      .Required();
  command.AddOption("--engine", &parsed->engine, "slurm or parallel")
      .Required()
      .OneOf({"slurm", "parallel"});
  command.AddOption("--shards", &options.num_shards, "Parts; default: 4")
      .InRange(int64_t{1}, kMaxShards);
  command.AddOption("--cpus", &options.num_cpus, "Trials at the same time within a shard")
      .InRange(1, kMaxCampaignJobs);
  command.AddOption("--partition", &options.partition, "Slurm's partition");
  command.AddOption("--time", &options.time, "Slurm's time limit of a shard, such as 2:00:00");
  command.AddOption("--sbatch", &parsed->sbatch, "More arguments of sbatch, between blanks");
  command.AddOption("--hosts", &options.hosts, "GNU parallel: hosts for ssh, between commas");
  command.AddOption("--sshloginfile", &options.login_file, "GNU parallel: a file of hosts");
  command.AddFlag("--no-follow", &parsed->no_follow, "Slurm: submit, and do not wait");
  command.AddFlag("--quiet", &options.quiet, "No line of progress");
  command.Callback([parsed, action] {
    *action = [parsed] {
      CampaignSubmitOptions& chosen = parsed->options;
      chosen.engine = parsed->engine == "slurm" ? CampaignSubmitOptions::Engine::kSlurm
                                                : CampaignSubmitOptions::Engine::kParallel;
      chosen.sbatch = SplitWords(parsed->sbatch);
      chosen.follows = !parsed->no_follow;
      return RunCampaignSubmit(chosen);
    };
  });
}

void AddCampaignReplay(Command campaign, CommandAction* action) {
  const Command command = campaign.AddSubcommand("replay", "Run one trial again, with a recording");
  auto options = std::make_shared<CampaignReplayOptions>();
  AddFolder(command, &options->dir);
  command.AddOption("TRIAL", &options->trial, "CASE-REPETITION, as reports name it").Required();
  command.AddFlag("--view", &options->is_viewed, "Then open it in the viewer");
  command.AddOption(
      "--out", &options->out,
      "Folder of the recording; default: DIR/replays/TRIAL; what it holds is removed first");
  command.AddFlag("--allow-build", &options->allow_build, "Even where shoal is another build");
  command.Callback(
      [options, action] { *action = [options] { return RunCampaignReplay(*options); }; });
}

void AddCampaignReport(Command campaign, CommandAction* action) {
  const Command command =
      campaign.AddSubcommand("report", "Show shares, means and percentiles with their intervals");
  auto options = std::make_shared<CampaignAnswerOptions>();
  AddFolder(command, &options->dir);
  CampaignReportOptions& report = options->report;
  command.AddFlag("--all", &report.all, "Every case, however many there are");
  const Option html = command.AddOption("--html", &options->page_path,
                                        "Write a page for a browser; default: DIR/report.html");
  html.WithOptionalValue();
  const Option plots = command.AddOption("--plots", &report.plots_dir,
                                         "Draw figures with gnuplot; default: DIR/plots");
  plots.WithOptionalValue();
  command.AddFlag("--png", &report.png, "Figures are PNG instead of SVG").Needs(plots);
  command.AddFlag("--keep", &report.keep, "Leave gnuplot's data and scripts there").Needs(plots);
  command.Callback([options, html, plots, action] {
    *action = [options, has_page = html.IsGiven(), has_plots = plots.IsGiven()] {
      options->has_page = has_page;
      options->report.plots = has_plots;
      if (options->report.plots_dir.empty()) options->report.plots_dir = options->dir + "/plots";
      if (const char* path = std::getenv("PATH")) options->report.search_path = path;
      return ReportCampaign(*options);
    };
  });
}

void AddCampaignCompare(Command campaign, CommandAction* action) {
  const Command command =
      campaign.AddSubcommand("compare", "Show paired differences between policies or sweep values");
  struct Parsed {
    std::string dir;
    CampaignCompareOptions options;
  };
  auto parsed = std::make_shared<Parsed>();
  AddFolder(command, &parsed->dir);
  command.AddOption("--a", &parsed->options.a, "KEY=VALUE, such as policy=A").Required();
  command.AddOption("--b", &parsed->options.b, "What to compare it with").Required();
  command.Callback([parsed, action] {
    *action = [parsed] { return CompareCampaign(parsed->dir, parsed->options); };
  });
}

void AddCampaignOfFolder(Command campaign, const std::string& name, const std::string& text,
                         int (*run)(const std::string&), CommandAction* action) {
  const Command command = campaign.AddSubcommand(name, text);
  auto dir = std::make_shared<std::string>();
  AddFolder(command, dir.get());
  command.Callback([dir, run, action] { *action = [dir, run] { return run(*dir); }; });
}

}  // namespace

void AddCampaignCommands(Command campaign, CommandAction* action) {
  campaign.RequireSubcommand();
  AddCampaignCheck(campaign, action);
  AddCampaignRun(campaign, action);
  AddCampaignSubmit(campaign, action);
  AddCampaignOfFolder(campaign, "status", "Show how far a campaign is, in a line",
                      RunCampaignStatus, action);
  AddCampaignOfFolder(campaign, "reduce", "Make results.csv and results.sqlite from the shards",
                      RunCampaignReduce, action);
  AddCampaignReport(campaign, action);
  AddCampaignCompare(campaign, action);
  AddCampaignReplay(campaign, action);
}

int RunShoalCampaign(int argc, char** argv) {
  return RunToolCommand("campaign", argc, argv, AddCampaignCommands);
}

}  // namespace shoal
