#include "lib/tools/trials/worker_pool.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <map>

#include "lib/base/check/check.h"

namespace shoal {
namespace {

const std::vector<MetricName> kOneMetric = {{"number", "", ""}};

TrialResult Passed(double value) {
  return {.outcome = TrialOutcome::kPass, .why = "", .metrics = {value}};
}

/// Runs repetitions 1 to `count` and returns their results.
std::map<int64_t, TrialResult> RunAll(int64_t count, int num_workers, double timeout_s,
                                      const WorkerPool::RunTrial& run) {
  WorkerPool pool({.num_workers = num_workers, .timeout_s = timeout_s, .metrics = kOneMetric}, run);
  EXPECT_EQ(pool.problem(), "");
  std::map<int64_t, TrialResult> results;
  int64_t next = 1;
  while (static_cast<int64_t>(results.size()) < count) {
    while (next <= count && pool.HasIdle()) {
      pool.Start({.case_number = 0, .repetition = next++});
    }
    for (FinishedJob& done : pool.Wait(100)) {
      EXPECT_TRUE(results.emplace(done.job.repetition, std::move(done.result)).second)
          << "a trial was finished twice";
    }
  }
  return results;
}

TEST(WorkerPool, RunsEachTrialOnceInProcessesOfItsOwn) {
  const auto results = RunAll(100, 3, 60, [parent = getpid()](const TrialJob& job, TrialProgress*) {
    return Passed(getpid() == parent ? -1 : static_cast<double>(job.repetition * job.repetition));
  });
  ASSERT_EQ(results.size(), 100U);
  for (const auto& [repetition, result] : results) {
    EXPECT_EQ(result.metrics.at(0), static_cast<double>(repetition * repetition));
  }
}

TEST(WorkerPool, NamesASignalThatATrialAlwaysEndsBy) {
  const auto results = RunAll(5, 2, 60, [](const TrialJob& job, TrialProgress*) {
    SHOAL_CHECK(job.repetition != 3, "the third trial is sound");
    return Passed(1);
  });
  for (const auto& [repetition, result] : results) {
    EXPECT_EQ(result.outcome, repetition == 3 ? TrialOutcome::kError : TrialOutcome::kPass);
  }
  const std::string& why = results.at(3).why;
  EXPECT_TRUE(why.starts_with("signal 6 (Aborted), in each of 2 attempts: ")) << why;
  EXPECT_NE(why.find("the third trial is sound"), std::string::npos) << why;
  EXPECT_NE(why.find("worker_pool_test.cc"), std::string::npos) << why;
}

TEST(WorkerPool, RunsATrialAgainWhoseWorkerWasKilledFromOutside) {
  // Killed at its first attempt alone, as by a user or for want of memory.
  int pipe_ends[2];
  ASSERT_EQ(pipe2(pipe_ends, O_NONBLOCK), 0);
  ASSERT_EQ(write(pipe_ends[1], "x", 1), 1);
  const auto results = RunAll(20, 2, 60, [&](const TrialJob& job, TrialProgress*) {
    char token = 0;
    if (job.repetition == 7 && read(pipe_ends[0], &token, 1) == 1) raise(SIGKILL);
    return Passed(static_cast<double>(job.repetition));
  });
  EXPECT_EQ(results.at(7).outcome, TrialOutcome::kPass);
  EXPECT_EQ(results.at(7).metrics.at(0), 7);
  close(pipe_ends[0]);
  close(pipe_ends[1]);
}

TEST(WorkerPool, EndsATrialThatRunsForEverAndStatesHowFarItWas) {
  const auto results = RunAll(4, 2, 0.3, [](const TrialJob& job, TrialProgress* progress) {
    progress->duration = 600'000'000;
    progress->utime = 37'200'000;
    while (job.repetition == 2) usleep(1000);
    return Passed(1);
  });
  EXPECT_EQ(results.at(2).outcome, TrialOutcome::kTimeout);
  EXPECT_EQ(
      results.at(2).why,
      "did not end within 0.3 s of wall time (timeout_s), at 37.2 of 600.0 s of mission time");
  EXPECT_EQ(results.at(3).outcome, TrialOutcome::kPass);
  EXPECT_EQ(results.at(4).outcome, TrialOutcome::kPass);
}

TEST(WorkerPool, NamesAProcessThatLeavesByItself) {
  const auto results = RunAll(2, 1, 60, [](const TrialJob& job, TrialProgress*) {
    if (job.repetition == 1) _exit(9);
    return Passed(1);
  });
  EXPECT_EQ(results.at(1).why, "the process ended with exit code 9, in each of 2 attempts");
}

TEST(WorkerPool, TakesResultsLongerThanAPipeAndOutputOfAnyLength) {
  const auto results = RunAll(3, 1, 60, [](const TrialJob&, TrialProgress*) {
    for (int i = 0; i < 100'000; ++i) std::puts("a line that a trial writes");
    return TrialResult{
        .outcome = TrialOutcome::kFail, .why = std::string(4000, '"'), .metrics = {2}};
  });
  for (const auto& [repetition, result] : results) EXPECT_EQ(result.why, std::string(4000, '"'));
}

}  // namespace
}  // namespace shoal
