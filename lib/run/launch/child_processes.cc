#include "lib/run/launch/child_processes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <deque>
#include <fstream>

#include "lib/bus/os/child.h"
#include "lib/bus/os/file_bytes.h"

namespace shoal {

namespace {

constexpr size_t kLastLines = 5;

const char* WhyNotExecuted(int error) {
  switch (error) {
    case ENOENT:
      return "the interpreter that its first line names is missing (a line that ends in CR LF "
             "names "
             "one too many)";
    case ENOEXEC:
      return "it is not a program of this machine; a script begins with #! and its interpreter";
    case EACCES:
      return "permission denied, for it or its interpreter";
    default:
      return "the system refuses";
  }
}

}  // namespace

std::vector<std::string> LastLines(const std::string& path, size_t count) {
  std::ifstream in(path);
  std::deque<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  return {lines.begin(), lines.end()};
}

ChildProcesses::~ChildProcesses() {
  SignalAll(SIGKILL);
  for (const auto& [name, child] : running_) waitpid(child.pid, nullptr, 0);
}

Result<pid_t> ChildProcesses::Start(const ChildCommand& command) {
  if (IsRunning(command.name)) {  // What is not in running_ would outlive this process.
    return Error{fmt::format("cannot start {}: it runs already", command.name)};
  }
  // A private log is made by this process, so that no other has opened it before.
  const FileDescriptor log(open(command.log_path.c_str(),
                                O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC |
                                    (command.is_log_private ? O_EXCL : 0),
                                command.is_log_private ? 0600 : 0644));
  if (!log.is_open()) {
    return Error{fmt::format("cannot write {}: {}", command.log_path, ErrnoText(errno))};
  }
  const Result<StartedProgram> started = StartProgram({.argv = command.argv,
                                                       .environment = command.environment,
                                                       .output = log.get(),
                                                       .errors = log.get(),
                                                       .kept = command.inherited_fd,
                                                       .own_group = true,
                                                       .dies_with_parent = true});
  if (!started.ok()) {
    return Error{fmt::format("cannot start {}: {}", command.name, started.error())};
  }
  if (started->exec_error != 0) {  // In its log, where its own last words would be.
    [[maybe_unused]] const bool is_written =
        WriteAll(log.get(), fmt::format("cannot execute {}: {}\n", command.argv[0],
                                        WhyNotExecuted(started->exec_error)));
  }
  const pid_t pid = started->pid;
  running_[command.name] = {.pid = pid, .log_path = command.log_path};
  return pid;
}

std::vector<ChildExit> ChildProcesses::Reap() {
  std::vector<ChildExit> exits;
  for (auto child = running_.begin(); child != running_.end();) {
    int status = 0;
    if (waitpid(child->second.pid, &status, WNOHANG) != child->second.pid) {
      ++child;
      continue;
    }
    kill(-child->second.pid, SIGKILL);  // What a user's script left behind.
    exits.push_back({.name = child->first,
                     .pid = child->second.pid,
                     .clean = WIFEXITED(status)
                                  ? WEXITSTATUS(status) == 0
                                  : (child->second.signals >> WTERMSIG(status) & 1) != 0,
                     .how = HowItEnded(status),
                     .last_lines = LastLines(child->second.log_path, kLastLines)});
    child = running_.erase(child);
  }
  return exits;
}

void ChildProcesses::Signal(const std::string& name, int signal) {
  const auto found = running_.find(name);
  if (found != running_.end()) Signal(&found->second, signal);
}

void ChildProcesses::SignalAllBut(const std::string& spared, int signal) {
  for (auto& [name, child] : running_) {
    if (name != spared) Signal(&child, signal);
  }
}

/// To the whole group: a user's command may be a script with children.
void ChildProcesses::Signal(Child* child, int signal) {
  child->signals |= uint64_t{1} << signal;
  kill(-child->pid, signal);
}

}  // namespace shoal
