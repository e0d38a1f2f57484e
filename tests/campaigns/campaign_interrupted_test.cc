// Whatever ends a campaign, what was finished is kept, and the same command goes on.
#include <gtest/gtest.h>
#include <signal.h>

#include "lib/base/random/stream.h"
#include "tests/campaigns/campaign_runs.h"

namespace shoal::campaign_interrupted_test {

/// Returns the children of a process.
std::vector<pid_t> ChildrenOf(pid_t pid) {
  const std::string path =
      "/proc/" + std::to_string(pid) + "/task/" + std::to_string(pid) + "/children";
  std::vector<pid_t> children;
  const std::string text = ReadFile(path);
  for (size_t at = 0; at < text.size();) {
    const size_t end = text.find(' ', at);
    if (end == std::string::npos) break;
    children.push_back(std::stoi(text.substr(at, end - at)));
    at = end + 1;
  }
  return children;
}

TEST(CampaignShards, GiveTheSameBytesAsOneJobWhateverTheirNumber) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(20));
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "one", {"--jobs", "1"}).exit_code, 0);
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "two", {"--jobs", "2"}).exit_code, 0);
  for (const char* shard : {"3/4", "1/4", "4/4", "2/4"}) {
    const Finished run = RunCampaignTo(folder, "c.toml", "four", {"--shard", shard});
    EXPECT_EQ(run.exit_code, 0) << run.output;
  }
  for (const char* file : {"results.csv", "results.sqlite"}) {
    const std::string bytes = ReadFile(folder / "one" / file);
    EXPECT_GT(bytes.size(), 1000U);
    EXPECT_EQ(ReadFile(folder / "two" / file), bytes) << file;
    EXPECT_EQ(ReadFile(folder / "four" / file), bytes) << file;
  }
}

TEST(CampaignShards, CanBeCutAnotherWayHalfWayThrough) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(10));
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "one").exit_code, 0);
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "cut", {"--shard", "1/3"}).exit_code, 0);
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "cut", {"--shard", "2/2"}).exit_code, 0);
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "cut").exit_code, 0);
  EXPECT_EQ(StoredLines(folder / "cut").size(), 20U);
  EXPECT_EQ(ReadFile(folder / "cut" / "results.csv"), ReadFile(folder / "one" / "results.csv"));
}

TEST(CampaignShards, TakeMoreRepetitionsLaterWithoutRunningAnyAgain) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(15));
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "one").exit_code, 0);
  WriteFile(folder / "few.toml", BertaCampaign(5));
  ASSERT_EQ(RunCampaignTo(folder, "few.toml", "more").exit_code, 0);
  const Finished more = RunCampaignTo(folder, "c.toml", "more");
  EXPECT_EQ(more.exit_code, 0) << more.output;
  EXPECT_EQ(more.output.find("20 trials in"), 0U) << more.output;
  EXPECT_EQ(ReadFile(folder / "more" / "results.csv"), ReadFile(folder / "one" / "results.csv"));
}

// 20 kills at moments of a fixed stream.
TEST(CampaignKilled, LosesNoTrialThatWasStoredAndRunsNoneTwice) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(60));
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "one").exit_code, 0);
  Stream stream(1, "moments of kills");
  std::vector<std::string> before;
  for (int i = 0; i < 20; ++i) {
    RunningProcess campaign(
        folder, {Program("shoal"), "campaign", "run", (folder / "c.toml").string(), "--out",
                 (folder / "killed").string(), "--quiet"});
    SleepSeconds(0.02 + 0.15 * stream.Uniform());
    if (stream.Uniform() < 0.5) {
      for (const pid_t worker : ChildrenOf(campaign.pid())) kill(worker, SIGKILL);
      SleepSeconds(0.05);
    }
    campaign.Signal(SIGKILL);
    campaign.Wait();
    const std::vector<std::string> after = StoredLines(folder / "killed");
    for (const std::string& line : before) {
      EXPECT_NE(std::find(after.begin(), after.end(), line), after.end()) << "lost: " << line;
    }
    before = after;
  }
  const Finished last = RunCampaignTo(folder, "c.toml", "killed");
  EXPECT_EQ(last.exit_code, 0) << last.output;
  for (const char* file : {"results.csv", "results.sqlite"}) {
    EXPECT_EQ(ReadFile(folder / "killed" / file), ReadFile(folder / "one" / file)) << file;
  }
  // Keys of trials: each stands there once.
  std::set<std::string> keys;
  int num_trials = 0;
  for (const std::string& line : StoredLines(folder / "killed")) {
    const size_t end = line.find(",\"outcome\"");
    if (end == std::string::npos) continue;  // Torn by a kill.
    ++num_trials;
    EXPECT_TRUE(keys.insert(line.substr(0, end)).second) << line;
  }
  EXPECT_EQ(num_trials, 120);
}

TEST(CampaignInterrupted, FinishesTheTrialsUnderWayAndGoesOnLater) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(100));
  RunningProcess campaign(
      folder, {Program("shoal"), "campaign", "run", (folder / "c.toml").string(), "--out",
               (folder / "out").string(), "--quiet"});
  ASSERT_TRUE(AwaitThat([&] { return StoredLines(folder / "out").size() >= 5; }));
  campaign.Signal(SIGINT);
  const Finished finished = campaign.Wait();
  EXPECT_EQ(finished.exit_code, 1) << finished.output;
  EXPECT_NE(finished.output.find("are missing; the same command goes on"), std::string::npos)
      << finished.output;
  const size_t num_stored = StoredLines(folder / "out").size();
  EXPECT_LT(num_stored, 200U);
  const Finished rest = RunCampaignTo(folder, "c.toml", "out");
  EXPECT_EQ(rest.exit_code, 0) << rest.output;
  EXPECT_EQ(rest.output.find(std::to_string(200 - num_stored) + " trials in"), 0U) << rest.output;
}

TEST(CampaignInterrupted, BeginsNoTrialAfterItsTime) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(100'000));
  const Finished finished = RunCampaignTo(folder, "c.toml", "out", {"--max-time", "1s"});
  EXPECT_EQ(finished.exit_code, 1) << finished.output;
  EXPECT_NE(finished.output.find("of 200000 trials of shard 1/1 are missing"), std::string::npos)
      << finished.output;
}

TEST(CampaignInterrupted, LeavesNoWorkerBehindWhereItIsKilled) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(1000));
  RunningProcess campaign(
      folder, {Program("shoal"), "campaign", "run", (folder / "c.toml").string(), "--out",
               (folder / "out").string(), "--jobs", "3"});
  std::map<std::string, pid_t> workers;
  ASSERT_TRUE(AwaitThat([&] { return ChildrenOf(campaign.pid()).size() == 3; }));
  for (const pid_t worker : ChildrenOf(campaign.pid())) workers[std::to_string(worker)] = worker;
  campaign.Signal(SIGKILL);
  campaign.Wait();
  EXPECT_TRUE(AllGone(workers));
}

}  // namespace shoal::campaign_interrupted_test
