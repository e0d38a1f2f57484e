// Runs build/bin/shoal (or any program) as a user would, and looks at what comes of it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/patience.h"

namespace shoal {

/// How long a test waits for what it expects: enough for a machine with many times as much to do. A
/// test that passes waits as long as it takes.
inline constexpr double kPatience_s = 150 * kPatienceFactor;

/// A folder of its own for one test; removed at the end.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct Finished {
  int exit_code = -1;  ///< -1: killed by a signal.
  std::string output;  ///< Standard output and error together.
  double wall_s = 0;
};

/// A process that runs while the test does something to it.
class RunningProcess {
 public:
  /// Starts `argv` with SHOAL_RUN_DIR inside `folder`, so that tests do not see each other.
  RunningProcess(const TestFolder& folder, std::vector<std::string> argv);
  ~RunningProcess();
  RunningProcess(const RunningProcess&) = delete;
  RunningProcess& operator=(const RunningProcess&) = delete;

  pid_t pid() const { return pid_; }
  void Signal(int signal) const;
  /// Returns all that it printed so far.
  std::string Output() const;
  /// Waits until `text` was printed. Returns false after `patience_s` or where it ended before.
  bool WaitFor(const std::string& text, double patience_s = kPatience_s) const;
  /// Waits for the end; after `patience_s` it is killed and the exit code is -1.
  Finished Wait(double patience_s = kPatience_s);

  /// Returns its children by their participants' names ("helm_alpha"), or their group's
  /// ("group-alpha").
  std::map<std::string, pid_t> Participants() const;

 private:
  bool HasEnded() const;
  pid_t pid_ = -1;
  std::filesystem::path output_path_;
  double started_s_ = 0;
  mutable int status_ = 0;
  mutable bool ended_ = false;
};

/// Runs `shoal` with `arguments` to its end.
Finished RunShoal(const TestFolder& folder, std::vector<std::string> arguments,
                  double patience_s = kPatience_s);

/// Sends a datagram of any content to LCM's group at a port, on this machine only.
void SendDatagram(int port, std::string_view datagram);

/// Waits until `holds` returns true, for kPatience_s at most; returns whether it did.
bool AwaitThat(const std::function<bool()>& holds);

/// Asks `app` for its status page until `holds` returns true for it, for kPatience_s at most;
/// returns the last page. A test that expects something of a running mission waits for it so.
std::string AwaitPage(const TestFolder& folder, const std::string& app,
                      const std::function<bool(const std::string& page)>& holds);
/// Awaits a page that holds all of `texts`.
std::string AwaitStatus(const TestFolder& folder, const std::string& app,
                        const std::vector<std::string>& texts);

/// Returns the path of an executable of this build.
std::string Program(const std::string& name);
/// Returns the path of a file in missions/.
std::string MissionFile(const std::string& name);
/// Copies the tracks and grids that missions of missions/ read to where a copy of one in `folder`
/// looks for them.
void CopyMissionData(const std::filesystem::path& folder);

/// Returns the first of `count` TCP ports in a row on which no program listens now.
int FreeTcpPorts(int count);

std::string ReadFile(const std::filesystem::path& path);
void WriteFile(const std::filesystem::path& path, const std::string& text);

/// True where the process exists (zombies count as gone).
bool IsAlive(pid_t pid);
/// Waits until none of these processes exists.
bool AllGone(const std::map<std::string, pid_t>& processes);
/// Waits until the process has been stopped by SIGSTOP.
bool IsStopped(pid_t pid);

double WallSeconds();
void SleepSeconds(double seconds);

}  // namespace shoal
