#include "lib/tools/analysis/plot_gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>

#include "lib/bus/record/file_descriptor.h"

extern char** environ;  // NOLINT: POSIX has it so

namespace shoal {

namespace {

/// Returns what can be read until the other end is closed; of long output, the beginning.
std::string ReadAll(int fd) {
  constexpr size_t kMax = 4000;
  std::string text;
  std::array<char, 4096> buffer;
  while (true) {
    const ssize_t size = ::read(fd, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return text;
    if (text.size() < kMax) text.append(buffer.data(), static_cast<size_t>(size));
  }
}

/// What the child's files are, and where it works.
class SpawnActions {
 public:
  SpawnActions(const std::string& folder, int messages) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, messages, STDERR_FILENO);
  }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

}  // namespace

std::string FindExecutable(std::string_view name, std::string_view search_path) {
  for (size_t begin = 0; begin < search_path.size();) {
    const size_t end = std::min(search_path.find(':', begin), search_path.size());
    const std::string_view folder = search_path.substr(begin, end - begin);
    begin = end + 1;
    if (folder.empty()) continue;
    const std::filesystem::path candidate = std::filesystem::path(folder) / name;
    std::error_code error;
    if (!std::filesystem::is_regular_file(candidate, error)) continue;
    if (::access(candidate.c_str(), X_OK) == 0) {
      return std::filesystem::absolute(candidate, error).string();
    }
  }
  return {};
}

Result<bool> RunGnuplot(const std::string& program, const std::string& folder,
                        const std::string& script) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    return Error{fmt::format("cannot run {}: {}", program, ErrnoText(errno))};
  }
  const FileDescriptor to_read(ends[0]);
  FileDescriptor to_write(ends[1]);
  // -d: not the settings that a user has for sessions of his own.
  std::string name = program;
  std::string no_settings = "-d";
  std::string script_name = script;
  char* argv[] = {name.data(), no_settings.data(), script_name.data(), nullptr};
  pid_t pid = 0;
  const SpawnActions actions(folder, to_write.get());
  const int failure = ::posix_spawn(&pid, program.c_str(), actions.get(), nullptr, argv, environ);
  if (failure != 0) return Error{fmt::format("cannot run {}: {}", program, ErrnoText(failure))};
  to_write.Close();
  const std::string output = ReadAll(to_read.get());
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
  const std::string how = WIFSIGNALED(status)
                              ? fmt::format("was killed by signal {}", WTERMSIG(status))
                              : fmt::format("exited with code {}", WEXITSTATUS(status));
  return Error{fmt::format("{} {} drawing {}; its output:\n{}", program, how, script, output)};
}

}  // namespace shoal
