#include "lib/bus/os/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <span>
#include <string_view>

#include "lib/bus/os/file_bytes.h"

extern char** environ;  // NOLINT: POSIX has it so

namespace shoal {

namespace {

/// Where a child's descriptors wait until they get their numbers: above those that they get.
constexpr int kAbove = 10;

std::vector<std::string> EnvironmentWith(const std::vector<std::string>& added) {
  std::vector<std::string> environment = added;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view own = *variable;
    const std::string_view key = own.substr(0, own.find('=') + 1);
    const bool is_replaced = std::any_of(
        added.begin(), added.end(), [&](const std::string& each) { return each.starts_with(key); });
    if (!is_replaced) environment.emplace_back(own);
  }
  return environment;
}

std::vector<char*> Pointers(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// Returns a copy of `fd` from kAbove on; not open if there is none. errno holds the reason, and
/// keeps it if `fd` is -1 because of an earlier failure.
FileDescriptor CopyOf(int fd) {
  return FileDescriptor(fd < 0 ? -1 : ::fcntl(fd, F_DUPFD_CLOEXEC, kAbove));
}

/// The same of /dev/null if `fd` is -1.
FileDescriptor CopyOrNull(int fd, int flags) {
  if (fd >= 0) return CopyOf(fd);
  const FileDescriptor null(::open("/dev/null", flags | O_CLOEXEC));
  return CopyOf(null.get());
}

/// In the child, from here on: only async-signal-safe calls. Other threads may have held locks.
struct ChildSide {
  const ProgramStart& start;
  pid_t parent;
  int input;
  int output;
  int errors;
  int kept;
  int news;  ///< Where a failure to execute is reported.
  std::span<char* const> argv;
  std::span<char* const> environment;

  [[noreturn]] void Run() const {
    if (start.own_group) ::setpgid(0, 0);
    ::signal(SIGPIPE, SIG_DFL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    if (start.dies_with_parent) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (::getppid() != parent) ::_exit(127);
    }
    ::dup2(input, STDIN_FILENO);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(errors, STDERR_FILENO);
    // liblcm's sockets have no such flag. Descriptors that are copied lose theirs.
    ::close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);
    if (start.kept >= 0 && start.kept_as < 0) ::fcntl(start.kept, F_SETFD, 0);
    if (start.kept >= 0 && start.kept_as >= 0) ::dup2(kept, start.kept_as);
    if (start.folder.empty() || ::chdir(start.folder.c_str()) == 0) {
      // With a search on the PATH, a file that is not a program would be given to the shell.
      const bool is_path = ::strchr(argv[0], '/') != nullptr;
      if (is_path) ::execve(argv[0], argv.data(), environment.data());
      if (!is_path) ::execvpe(argv[0], argv.data(), environment.data());
    }
    const int error = errno;
    [[maybe_unused]] const ssize_t written = ::write(news, &error, sizeof error);
    ::_exit(127);
  }
};

}  // namespace

Pipe MakePipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return {};
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

Result<StartedProgram> StartProgram(const ProgramStart& start) {
  const std::vector<std::string> environment = EnvironmentWith(start.environment);
  const std::vector<char*> argv = Pointers(start.argv);
  const std::vector<char*> envp = Pointers(environment);
  const FileDescriptor input = CopyOrNull(start.input, O_RDONLY);
  const FileDescriptor output = CopyOrNull(start.output, O_WRONLY);
  const FileDescriptor errors = CopyOrNull(start.errors, O_WRONLY);
  const FileDescriptor kept = CopyOf(start.kept);
  Pipe news = MakePipe();
  FileDescriptor to_report = CopyOf(news.write.get());
  const bool has_all = input.is_open() && output.is_open() && errors.is_open() &&
                       (start.kept < 0 || kept.is_open()) && to_report.is_open();
  if (!has_all) return Error{ErrnoText(errno)};
  const ChildSide child{.start = start,
                        .parent = ::getpid(),
                        .input = input.get(),
                        .output = output.get(),
                        .errors = errors.get(),
                        .kept = kept.get(),
                        .news = to_report.get(),
                        .argv = argv,
                        .environment = envp};
  StartedProgram started{.pid = ::fork()};
  if (started.pid == 0) child.Run();
  if (started.pid < 0) {
    return Error{
        fmt::format("{} (ulimit -u shows how many processes you may have)", ErrnoText(errno))};
  }
  if (start.own_group) ::setpgid(started.pid, started.pid);  // In both: whichever comes first.
  // The child's copies are closed as it executes the program, and then there is nothing to read.
  news.write = {};
  to_report = {};
  int error = 0;
  char bytes[sizeof error];
  if (ReadAll(news.read.get(), bytes)) {
    std::memcpy(&error, bytes, sizeof error);
    started.exec_error = error;
  }
  return started;
}

pid_t ForkWithParent() {
  const pid_t parent = ::getpid();
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(kExitEnvironment);  // It ended in between.
  }
  return pid;
}

int WaitFor(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string HowItEnded(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("was killed by signal {} ({})", WTERMSIG(status),
                       ::strsignal(WTERMSIG(status)));
  }
  return fmt::format("exited with code {}", WEXITSTATUS(status));
}

}  // namespace shoal
