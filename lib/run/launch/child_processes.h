// The processes that the launcher started: each with a group and a log of its own, none left
// behind. (Where the launcher itself is killed by SIGKILL, its children die with it; what a user's
// script has started does not.)
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

/// How a child ended.
struct ChildExit {
  std::string name;
  pid_t pid = 0;
  bool clean = false;  ///< Exit code 0, or killed by a signal that this process sent it.
  std::string how;     ///< "was killed by signal 9 (Killed)", "exited with code 2".
  std::vector<std::string> last_lines;  ///< Of its log.
};

struct ChildCommand {
  std::string name;                      ///< Unique among the children that run.
  std::vector<std::string> argv;         ///< argv[0] is a path.
  std::vector<std::string> environment;  ///< "KEY=value", added to our own.
  std::string log_path;                  ///< Standard output and error, appended.
  bool is_log_private = false;           ///< Must be new; only this user can read it.
  int inherited_fd = -1;                 ///< Stays open in the child, under its number.
};

class ChildProcesses {
 public:
  ChildProcesses() = default;
  ~ChildProcesses();  ///< Kills what still runs.
  ChildProcesses(const ChildProcesses&) = delete;
  ChildProcesses& operator=(const ChildProcesses&) = delete;

  /// Starts a process. It dies with this one, whatever ends it.
  [[nodiscard]] Result<pid_t> Start(const ChildCommand& command);

  /// Returns the children that have ended since the last call. Never waits.
  std::vector<ChildExit> Reap();

  void Signal(const std::string& name, int signal);
  void SignalAll(int signal) { SignalAllBut("", signal); }
  /// Signals all but the one of this name.
  void SignalAllBut(const std::string& spared, int signal);

  bool IsRunning(const std::string& name) const { return running_.contains(name); }
  size_t num_running() const { return running_.size(); }

 private:
  struct Child {
    pid_t pid = 0;
    std::string log_path;
    uint64_t signals = 0;  ///< Those that were sent to it: bit n is signal n.
  };
  static void Signal(Child* child, int signal);

  std::map<std::string, Child> running_;
};

/// Returns the last `count` lines of a text file that are not empty; none where it cannot be read.
std::vector<std::string> LastLines(const std::string& path, size_t count);

}  // namespace shoal
