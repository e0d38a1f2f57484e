#include "lib/tools/trials/submit.h"

#include <gtest/gtest.h>

#include "lib/tools/campaign/campaign_testing.h"

namespace shoal::submit_test {

TEST(ShellQuote, KeepsBlanksQuotesAndDollarsFromTheShell) {
  EXPECT_EQ(ShellQuote("/a b/$x"), "'/a b/$x'");
  EXPECT_EQ(ShellQuote("it's"), "'it'\\''s'");
}

TEST(ShardScript, RunsTheShardOfTheArrayIndexInTheFolderOfTheCall) {
  const std::string text = ShardScriptText({.program = "/opt/my shoal/shoal",
                                            .working_folder = "/home/a",
                                            .campaign_file = "c.toml",
                                            .out = "/data/out",
                                            .num_shards = 40,
                                            .num_jobs = 2,
                                            .directives = {"--requeue"}});
  EXPECT_TRUE(text.starts_with("#!/bin/sh\n#SBATCH --requeue\n")) << text;
  EXPECT_NE(text.find("cd '/home/a' || exit 3\n"), std::string::npos) << text;
  EXPECT_NE(text.find("'/opt/my shoal/shoal' campaign run 'c.toml' --out '/data/out' --shard "
                      "\"$shard/40\" --jobs 2 --quiet &\n"),
            std::string::npos)
      << text;
}

TEST(MissingByShard, CountsWhatEachShardLacks) {
  CampaignFolder folder;
  folder.campaign.repetitions = 3;
  folder.plan.cases = {{.id = "a", .values = {}, .policy = ""}};
  StoredTrials stored;
  stored.by_case.resize(1);
  EXPECT_EQ(MissingByShard(folder, stored, 2), (std::map<int64_t, int64_t>{{1, 2}, {2, 1}}));
  stored.by_case[0][2] = {.key = {"a", 2}, .result = PassWith(1)};
  EXPECT_EQ(MissingByShard(folder, stored, 2), (std::map<int64_t, int64_t>{{1, 2}}));
}

TEST(ArrayText, JoinsNeighbours) {
  EXPECT_EQ(ArrayText({1, 2, 3, 4}), "1-4");
  EXPECT_EQ(ArrayText({1, 3, 4, 9}), "1,3-4,9");
}

TEST(SlurmJobs, AreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  const std::string path = folder / "jobs";
  ASSERT_EQ(AppendSlurmJob(path, {.id = 17, .num_shards = 4}), "");
  ASSERT_EQ(AppendSlurmJob(path, {.id = 21, .num_shards = 4}), "");
  EXPECT_EQ(ParseSlurmJobs("17 4\n21 4\n"), (std::vector<SlurmJob>{{17, 4}, {21, 4}}));
  EXPECT_EQ(ParseSlurmJobs("17\n-1 4\nx 4\n"), std::vector<SlurmJob>());
  EXPECT_NE(AppendSlurmJob(folder / "missing/jobs", {.id = 1, .num_shards = 1}), "");
}

TEST(SubmittedJob, IsTheNumberThatSbatchPrints) {
  EXPECT_EQ(ParseSubmittedJob("17\n"), 17);
  EXPECT_EQ(ParseSubmittedJob("welcome to the site\n18;cluster\n"), 18);
  EXPECT_EQ(ParseSubmittedJob(""), std::nullopt);
}

TEST(SlurmTasks, AreThoseOfOurJobsAlone) {
  const SlurmTasks tasks = ParseSlurmTasks(
      "17 RUNNING None\n17 PENDING Resources\n17 PENDING Priority\n99 RUNNING None\n"
      "17 COMPLETED None\n",
      {{17, 4}});
  EXPECT_EQ(tasks.num_running, 1);
  EXPECT_EQ(tasks.num_waiting, 2);
  EXPECT_EQ(tasks.reason, "Resources");
  EXPECT_TRUE(ParseSlurmTasks("17 COMPLETED None\n", {{17, 4}}).empty());
}

}  // namespace shoal::submit_test
