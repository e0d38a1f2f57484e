// Processes forked ahead that run one trial after another, in memory. A failed check, a signal or a
// runaway costs one trial: it is named, and the worker is replaced.
//
//   WorkerPool pool(options, [](const TrialJob& job, TrialProgress* progress) { return ...; });
//   while (...) {
//     while (pool.HasIdle()) pool.Start(next_job);
//     for (const FinishedJob& done : pool.Wait(100)) ...
//   }
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lib/bus/os/file_descriptor.h"
#include "lib/tools/metrics/metric.h"
#include "lib/tools/metrics/trial.h"
#include "lib/tools/trials/trial_line.h"

namespace shoal {

struct TrialJob {
  uint64_t case_number = 0;
  int64_t repetition = 1;
  bool is_recorded = false;  ///< Run again for its recording.
};

/// How far a worker is with its trial: shared memory, so that the parent can state it of one that
/// had to be killed.
struct TrialProgress {
  std::atomic<int64_t> utime = 0;     ///< Mission time since the start, microseconds.
  std::atomic<int64_t> duration = 0;  ///< Of the mission, microseconds; 0: not loaded yet.
  /// The trial ends itself at its time limit: it has processes to end before.
  std::atomic<bool> ends_itself = false;
};

/// Returns why a trial is a timeout.
[[nodiscard]] std::string TimeoutText(double timeout_s);

struct FinishedJob {
  TrialJob job;
  TrialResult result;
  double wall_s = 0;
};

class WorkerPool {
 public:
  using RunTrial = std::function<TrialResult(const TrialJob&, TrialProgress*)>;

  struct Options {
    int num_workers = 1;
    double timeout_s = 60;
    std::vector<MetricName> metrics;
    /// Called in each new worker: what it must give up.
    std::function<void()> in_worker = {};
  };

  /// Forks the workers. @pre this process has one thread
  WorkerPool(Options options, RunTrial run);
  /// Kills the workers.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Why there are too few workers: the machine allows no more processes. Empty: there are all.
  const std::string& problem() const { return problem_; }

  bool HasIdle() const;
  size_t num_busy() const;
  /// @pre HasIdle()
  void Start(const TrialJob& job);
  /// Waits for results: `timeout_ms` at most, or until a signal comes.
  std::vector<FinishedJob> Wait(int timeout_ms);

 private:
  struct Worker {
    pid_t pid = -1;
    FileDescriptor jobs;     ///< To it.
    FileDescriptor results;  ///< From it.
    FileDescriptor output;   ///< What it writes to standard output and error.
    TrialProgress* progress = nullptr;
    bool is_busy = false;
    TrialJob job;
    int num_deaths = 0;  ///< Of workers with this job.
    int64_t begin_us = 0;
    std::string received;
  };

  void Fork(Worker* worker);
  [[noreturn]] void Work(Worker* worker);
  void Send(Worker* worker);
  bool Receive(Worker* worker, std::vector<FinishedJob>* finished);
  void Remove(Worker* worker, std::vector<FinishedJob>* finished);
  void StopRunaway(Worker* worker, int64_t now_us, std::vector<FinishedJob>* finished);
  std::string LastOutput(const Worker& worker) const;
  void Conclude(Worker* worker, TrialResult result, std::vector<FinishedJob>* finished);

  Options options_;
  RunTrial run_;
  TrialProgress* progress_ = nullptr;  ///< One for each worker, shared.
  std::vector<Worker> workers_;
  std::string problem_;
};

}  // namespace shoal
