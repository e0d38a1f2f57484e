#include "lib/tools/plot/plot_gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>

#include "lib/bus/os/child.h"
#include "lib/bus/os/file_bytes.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

Result<bool> RunGnuplot(const std::string& program, const std::string& folder,
                        const std::string& script) {
  Pipe messages = MakePipe();
  if (!messages.read.is_open()) {
    return Error{fmt::format("cannot run {}: {}", program, ErrnoText(errno))};
  }
  // -d: gnuplot does not read the settings of the user.
  const Result<StartedProgram> started = StartProgram(
      {.argv = {program, "-d", script}, .folder = folder, .errors = messages.write.get()});
  if (!started.ok()) return Error{fmt::format("cannot run {}: {}", program, started.error())};
  if (started->exec_error != 0) {
    WaitFor(started->pid);
    return Error{fmt::format("cannot run {}: {}", program, ErrnoText(started->exec_error))};
  }
  messages.write = {};
  constexpr size_t kMaxRead_bytes = size_t{1} << 26;  // More has no reader: SIGPIPE ends it.
  constexpr size_t kMaxShown_bytes = 4000;
  std::string output;
  [[maybe_unused]] const bool was_read = ReadToEnd(messages.read.get(), kMaxRead_bytes, &output);
  messages.read = {};
  output.resize(std::min(output.size(), kMaxShown_bytes));
  const int status = WaitFor(started->pid);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
  return Error{fmt::format("{} {} drawing {}; its output:\n{}", program, HowItEnded(status), script,
                           output)};
}

}  // namespace shoal
