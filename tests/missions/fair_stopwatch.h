// Wall time as a process on this machine gets it: for bounds in seconds that hold on a busy
// machine.
//
//   const FairStopwatch stopwatch;
//   kill(pid, SIGINT);
//   ...
//   EXPECT_LT(stopwatch.Seconds(), 2.0);
//
// On a quiet machine these are seconds of wall time. Where more processes want to run than there
// are cores, a second counts as the share of one of them; where the machine stands still, it counts
// nothing.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <string>
#include <thread>

namespace shoal {

class FairStopwatch {
 public:
  FairStopwatch() : thread_([this] { Run(); }) {}
  ~FairStopwatch() {
    is_done_ = true;
    thread_.join();
  }
  FairStopwatch(const FairStopwatch&) = delete;
  FairStopwatch& operator=(const FairStopwatch&) = delete;

  double Seconds() const { return seconds_; }

 private:
  /// Returns how many processes there are for each core that want to run now; 1 at least.
  static double Crowd() {
    std::ifstream in("/proc/loadavg");
    double skipped = 0;
    double num_running = 0;
    in >> skipped >> skipped >> skipped >> num_running;
    return std::max(1.0, num_running / std::max(1U, std::thread::hardware_concurrency()));
  }

  void Run() {
    using std::chrono::steady_clock;
    constexpr double kLongest_s = 0.002;  // Of a sleep of half as much: longer is the machine's.
    for (auto last = steady_clock::now(); !is_done_;) {
      usleep(1'000);
      const auto now = steady_clock::now();
      const double slept_s = std::chrono::duration<double>(now - last).count();
      seconds_ = seconds_ + std::min(slept_s, kLongest_s) / Crowd();
      last = now;
    }
  }

  std::atomic<bool> is_done_ = false;
  std::atomic<double> seconds_ = 0;
  std::thread thread_;
};

}  // namespace shoal
