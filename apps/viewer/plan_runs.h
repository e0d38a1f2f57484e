// Missions that a page has started: each a `shoal run --view` of its own, which ends with the
// viewer.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/run/launch/child_processes.h"

namespace shoal {

class PlanRuns {
 public:
  static constexpr size_t kMaxRuns = 4;  ///< At one time.

  PlanRuns();
  ~PlanRuns();
  PlanRuns(const PlanRuns&) = delete;
  PlanRuns& operator=(const PlanRuns&) = delete;

  /// Starts the mission of a file, and waits until its viewer has an address. Returns the address,
  /// or why it does not run: its last words. From any thread.
  [[nodiscard]] Result<std::string> Start(const std::string& file,
                                          const std::vector<std::string>& overrides);

 private:
  struct Order {
    ChildCommand command = {};
    std::string error = {};  ///< Of the start.
    bool is_done = false;
  };

  void Work();

  std::mutex mutex_;
  std::condition_variable news_;
  ChildProcesses children_;
  std::deque<Order*> orders_;
  std::vector<ChildExit> exits_;
  int num_started_ = 0;
  bool is_stopping_ = false;
  /// Children die with the thread that has started them: those of connections come and go.
  std::thread thread_;
};

}  // namespace shoal
