#include "lib/tools/trials/trial_queue.h"

#include <gtest/gtest.h>

#include <set>

#include "lib/tools/campaign/folder_testing.h"

namespace shoal {
namespace {

CampaignFolder FolderOf(size_t num_cases, int64_t repetitions) {
  CampaignFolder folder;
  folder.campaign.repetitions = repetitions;
  for (size_t i = 0; i < num_cases; ++i)
    folder.plan.cases.push_back({.id = std::to_string(i), .values = {}, .policy = ""});
  folder.plan.metrics = {{"m", "", ""}};
  return folder;
}

StoredTrials NothingStored(const CampaignFolder& folder) {
  StoredTrials stored;
  stored.by_case.resize(folder.plan.cases.size());
  return stored;
}

using Trials = std::set<std::pair<size_t, int64_t>>;

/// Runs all of a queue with at most `most` trials under way; each result is by `result_of`.
Trials RunAll(TrialQueue* queue, size_t most,
              const std::function<TrialResult(size_t, int64_t)>& result_of) {
  Trials run;
  std::vector<TrialJob> under_way;
  for (;;) {
    while (under_way.size() < most) {
      const auto job = queue->Next();
      if (!job) break;
      EXPECT_TRUE(run.emplace(job->case_number, job->repetition).second) << "run twice";
      under_way.push_back(*job);
    }
    if (under_way.empty()) return run;
    const TrialJob job = under_way.back();  // Not in the order of their start.
    under_way.pop_back();
    queue->Finish(job, result_of(job.case_number, job.repetition));
  }
}

TrialResult Pass(size_t, int64_t) { return PassWith(1); }

TEST(TrialQueue, RunsTheFirstRepetitionOfAllCasesBeforeTheSecond) {
  const CampaignFolder folder = FolderOf(3, 2);
  TrialQueue queue(folder, {}, NothingStored(folder));
  for (const int64_t repetition : {1, 1, 1, 2, 2, 2})
    EXPECT_EQ(queue.Next()->repetition, repetition);
  EXPECT_FALSE(queue.Next());
}

TEST(TrialQueue, GivesEachTrialToOneShard) {
  for (const int64_t count : {1, 2, 4, 7, 40}) {
    const CampaignFolder folder = FolderOf(4, 9);
    Trials all;
    for (int64_t number = 1; number <= count; ++number) {
      TrialQueue queue(folder, {.number = number, .count = count}, NothingStored(folder));
      for (const auto& trial : RunAll(&queue, 2, Pass)) EXPECT_TRUE(all.insert(trial).second);
      EXPECT_EQ(queue.num_finished(), queue.num_planned());
    }
    EXPECT_EQ(all.size(), 36U) << count;
  }
}

TEST(TrialQueue, LeavesOutWhatIsStored) {
  const CampaignFolder folder = FolderOf(2, 5);
  StoredTrials stored = NothingStored(folder);
  stored.by_case[1][2].result = PassWith(1);
  stored.by_case[0][5].result = PassWith(1);
  TrialQueue queue(folder, {}, stored);
  EXPECT_EQ(queue.num_finished(), 2);
  const Trials run = RunAll(&queue, 3, Pass);
  EXPECT_EQ(run.size(), 8U);
  EXPECT_FALSE(run.contains({1, 2}));
  EXPECT_FALSE(run.contains({0, 5}));
}

/// Looks at 10 and 20 of 100; case 0 always passes, case 1 every other time.
CampaignFolder FolderWithStop() {
  CampaignFolder folder = FolderOf(2, 100);
  StopRule rule;
  rule.half_width = 0.3;
  rule.looks = {10, 20};
  rule.spending = Spending::kPocock;
  folder.campaign.stop = rule;
  return folder;
}

TrialResult EveryOther(size_t number, int64_t repetition) {
  TrialResult result = PassWith(1);
  if (number == 1 && repetition % 2 == 0) result.outcome = TrialOutcome::kFail;
  return result;
}

TEST(TrialQueue, StopsACaseAtALookAndNotBetween) {
  const CampaignFolder folder = FolderWithStop();
  for (const size_t workers : {size_t{1}, size_t{2}, size_t{7}}) {
    TrialQueue queue(folder, {}, NothingStored(folder));
    const Trials run = RunAll(&queue, workers, EveryOther);
    std::map<size_t, int64_t> last;
    for (const auto& [number, repetition] : run) last[number] = std::max(last[number], repetition);
    EXPECT_EQ(last[0], 10) << workers;
    EXPECT_EQ(last[1], 20) << workers;
    EXPECT_EQ(run.size(), 30U);
    EXPECT_EQ(queue.num_planned() - queue.num_spared(), queue.num_finished());
  }
}

TEST(TrialQueue, OfAShardEndsThoughOthersHaveNotBegun) {
  const CampaignFolder folder = FolderWithStop();
  TrialQueue queue(folder, {.number = 1, .count = 4}, NothingStored(folder));
  EXPECT_EQ(RunAll(&queue, 2, EveryOther).size(), 50U);
}

}  // namespace
}  // namespace shoal
