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

extern char** environ;  // NOLINT: POSIX has it so

namespace shoal {

namespace {

constexpr size_t kLastLines = 5;

std::string Describe(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("was killed by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  }
  return fmt::format("exited with code {}", WEXITSTATUS(status));
}

/// For a child that has no more than async-signal-safe calls.
const char* WhyNotExecuted(int error) {
  switch (error) {
    case ENOENT:
      return "the interpreter that its first line names is missing (a line that ends in CR LF "
             "names "
             "one too many)";
    case ENOEXEC:
      return "it is no program of this machine; a script begins with #! and its interpreter";
    case EACCES:
      return "permission denied, for it or its interpreter";
    default:
      return "the system refuses";
  }
}

std::vector<char*> Pointers(const std::vector<std::string>& strings) {
  std::vector<char*> pointers;
  pointers.reserve(strings.size() + 1);
  for (const std::string& each : strings) pointers.push_back(const_cast<char*>(each.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// Returns our own environment with `added` in place of what has the same names.
std::vector<std::string> EnvironmentWith(const std::vector<std::string>& added) {
  std::vector<std::string> environment = added;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view own(*entry);
    const std::string_view key = own.substr(0, own.find('=') + 1);
    bool replaced = false;
    for (const std::string& each : added) replaced = replaced || each.starts_with(key);
    if (!replaced) environment.emplace_back(own);
  }
  return environment;
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
  const std::vector<std::string> environment = EnvironmentWith(command.environment);
  const std::vector<char*> argv = Pointers(command.argv);
  const std::vector<char*> envp = Pointers(environment);
  // A private log is made by this process, so that no other has opened it before.
  const int log = open(command.log_path.c_str(),
                       O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC |
                           (command.is_log_private ? O_EXCL : 0),
                       command.is_log_private ? 0600 : 0644);
  if (log < 0) {
    return Error{fmt::format("cannot write {}: {}", command.log_path, std::strerror(errno))};
  }
  const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) {
    // Only async-signal-safe calls from here on: other threads may have held locks.
    setpgid(0, 0);  // Ctrl-C on the terminal is for the launcher alone.
    signal(SIGPIPE, SIG_DFL);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);  // liblcm's own have no such flag.
    if (command.inherited_fd >= 0) fcntl(command.inherited_fd, F_SETFD, 0);
    dup2(null, STDIN_FILENO);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    execve(argv[0], argv.data(), envp.data());
    const char* const why = WhyNotExecuted(errno);
    const char* const program = argv[0];
    for (const char* text : {"cannot execute ", program, ": ", why, "\n"}) {
      [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, strlen(text));
    }
    _exit(127);
  }
  const int fork_error = errno;
  close(log);
  if (null >= 0) close(null);
  if (pid < 0) {
    return Error{
        fmt::format("cannot start {}: {} (ulimit -u shows how many processes you may have)",
                    command.name, std::strerror(fork_error))};
  }
  setpgid(pid, pid);  // In both processes: whoever comes first.
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
                     .how = Describe(status),
                     .last_lines = LastLines(child->second.log_path, kLastLines)});
    child = running_.erase(child);
  }
  return exits;
}

void ChildProcesses::Signal(const std::string& name, int signal) {
  const auto found = running_.find(name);
  if (found != running_.end()) Signal(&found->second, signal);
}

void ChildProcesses::SignalAll(int signal) {
  for (auto& [name, child] : running_) Signal(&child, signal);
}

/// To the whole group: a user's command may be a script with children.
void ChildProcesses::Signal(Child* child, int signal) {
  child->signals |= uint64_t{1} << signal;
  kill(-child->pid, signal);
}

}  // namespace shoal
