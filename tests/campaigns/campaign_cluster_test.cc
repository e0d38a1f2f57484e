// Campaigns whose shards others run: a Slurm of one box, GNU parallel; trials that need processes.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/campaigns/campaign_runs.h"
#include "tests/campaigns/slurm_of_one_box.h"

namespace shoal::campaign_cluster_test {

void ExpectSameResults(const TestFolder& folder, const std::string& one, const std::string& other) {
  for (const char* file : {"results.csv", "results.sqlite"}) {
    const std::string bytes = ReadFile(folder / one / file);
    EXPECT_GT(bytes.size(), 100U);
    EXPECT_EQ(ReadFile(folder / other / file), bytes) << file;
  }
}

TEST(CampaignUnderSlurm, GivesTheSameBytesAsOneJobAndAfterACancelledArray) {
  if (!IsInstalled("slurmctld") || !IsInstalled("slurmd") || !IsInstalled("sbatch")) {
    GTEST_SKIP() << "no Slurm: scripts/setup --with-tests installs it";
  }
  const TestFolder folder;
  const SlurmOfOneBox slurm(folder);
  if (!slurm.is_up()) {
    GTEST_SKIP() << "this machine cannot start Slurm: "
                 << ReadFile(folder.path() / "slurm" / "log" / "ctld.log");
  }
  WriteFile(folder / "c.toml", BertaCampaign(100));
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "one", {"--jobs", "1"}).exit_code, 0);
  RunningProcess submit(
      folder, {Program("shoal"), "campaign", "submit", (folder / "c.toml").string(), "--out",
               (folder / "out").string(), "--engine", "slurm", "--shards", "4", "--quiet"});
  ASSERT_TRUE(AwaitThat([&] { return StoredLines(folder / "out").size() > 5; })) << submit.Output();
  EXPECT_EQ(std::system("scancel --name shoal"), 0);
  const Finished finished = submit.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("200 trials: 200 pass"), std::string::npos) << finished.output;
  ExpectSameResults(folder, "one", "out");
  const Finished again =
      RunShoal(folder, {"campaign", "submit", (folder / "c.toml").string(), "--out",
                        (folder / "out").string(), "--engine", "slurm", "--quiet"});
  EXPECT_EQ(again.exit_code, 0) << again.output;
  EXPECT_EQ(again.output.find("Slurm job"), std::string::npos) << again.output;
}

TEST(CampaignUnderParallel, GivesTheSameBytesAsOneJob) {
  if (!IsInstalled("parallel")) {
    GTEST_SKIP() << "no GNU parallel: scripts/setup --with-tests installs it";
  }
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(20));
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "one", {"--jobs", "1"}).exit_code, 0);
  const Finished finished =
      RunShoal(folder, {"campaign", "submit", (folder / "c.toml").string(), "--out",
                        (folder / "out").string(), "--engine", "parallel", "--shards", "4"});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  ExpectSameResults(folder, "one", "out");
}

TEST(CampaignSubmit, NamesThePackageOfAnEngineThatIsNotThere) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(2));
  RunningProcess submit(folder, {"/usr/bin/env", "PATH=/nonexistent", Program("shoal"), "campaign",
                                 "submit", (folder / "c.toml").string(), "--out",
                                 (folder / "out").string(), "--engine", "slurm"});
  const Finished finished = submit.Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find("in the package slurm-client"), std::string::npos)
      << finished.output;
}

TEST(CampaignOfProcesses, RunsAProgramOfTheUsersInTwoCampaignsAtATime) {
  const TestFolder folder;
  WriteFile(folder / "c.toml",
            "[campaign]\nmission = \"" + MissionFile("c_planner.toml") + "\"\nrepetitions = 2\n");
  RunningProcess other(folder, {Program("shoal"), "campaign", "run", (folder / "c.toml").string(),
                                "--out", (folder / "other").string(), "--jobs", "2", "--quiet"});
  const Finished one = RunCampaignTo(folder, "c.toml", "one", {"--jobs", "1"});
  EXPECT_EQ(one.exit_code, 0) << one.output;
  const Finished two = other.Wait();
  EXPECT_EQ(two.exit_code, 0) << two.output;
  ExpectSameResults(folder, "one", "other");
}

TEST(CampaignOfProcesses, NamesAProgramThatEndsTheSameInEveryRun) {
  const TestFolder folder;
  WriteFile(folder / "m.toml",
            "[mission]\nduration_s = 30\n[[vehicle]]\nname = \"alpha\"\n[[participant]]\n"
            "name = \"mine\"\ncommand = [\"/bin/sh\", \"-c\", \"exit 7\"]\n");
  WriteFile(folder / "c.toml", "[campaign]\nmission = \"m.toml\"\nrepetitions = 2\n");
  const Finished one = RunCampaignTo(folder, "c.toml", "one", {"--jobs", "1"});
  EXPECT_EQ(one.exit_code, 1) << one.output;
  EXPECT_NE(one.output.find("LOST: mine exited with code 7"), std::string::npos) << one.output;
  RunCampaignTo(folder, "c.toml", "two", {"--jobs", "2"});
  EXPECT_EQ(ReadFile(folder / "two" / "results.csv"), ReadFile(folder / "one" / "results.csv"));
}

TEST(CampaignOfProcesses, EndsAllOfThemAtTheTimeLimit) {
  const TestFolder folder;
  const std::string mark = "9" + std::to_string(getpid()) + "77";  // Seconds that others sleep not.
  WriteFile(folder / "m.toml",
            "[mission]\nduration_s = 30\n[[vehicle]]\nname = \"alpha\"\n[[participant]]\n"
            "name = \"mine\"\ncommand = [\"/bin/sleep\", \"" +
                mark + "\"]\n");
  WriteFile(folder / "c.toml",
            "[campaign]\nmission = \"m.toml\"\nrepetitions = 1\ntimeout_s = 2\n");
  const Finished run = RunCampaignTo(folder, "c.toml", "out", {"--keep", "none"});
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("1 timeout"), std::string::npos) << run.output;
  EXPECT_TRUE(AwaitThat([&] {
    return std::system(("pgrep -f 'sleep " + mark + "' | grep -v $$ > /dev/null").c_str()) != 0;
  }));
}

}  // namespace shoal::campaign_cluster_test
