#include "lib/bus/os/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lib/bus/os/child.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

namespace {

std::string TextOf(const FileDescriptor& file) {
  std::string text;
  char bytes[4096];
  for (off_t at = 0;;) {
    const ssize_t count = pread(file.get(), bytes, sizeof bytes, at);
    if (count <= 0) return text;
    text.append(bytes, static_cast<size_t>(count));
    at += count;
  }
}

}  // namespace

ProgramOutput RunProgram(const std::vector<std::string>& argv) {
  const FileDescriptor out(memfd_create("standard output", MFD_CLOEXEC));
  const FileDescriptor err(memfd_create("standard error", MFD_CLOEXEC));
  ProgramOutput output;
  const Result<StartedProgram> started =
      StartProgram({.argv = argv, .output = out.get(), .errors = err.get(), .own_group = true});
  if (!started.ok()) return output;
  const int status = WaitFor(started->pid);
  if (WIFEXITED(status)) output.exit_code = WEXITSTATUS(status);
  output.standard = TextOf(out);
  output.errors = TextOf(err);
  return output;
}

}  // namespace shoal
