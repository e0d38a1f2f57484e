#include "lib/run/launch/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "lib/bus/record/file_descriptor.h"

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
  std::vector<char*> pointers;
  for (const std::string& each : argv) pointers.push_back(const_cast<char*>(each.c_str()));
  pointers.push_back(nullptr);
  const FileDescriptor out(memfd_create("standard output", MFD_CLOEXEC));
  const FileDescriptor err(memfd_create("standard error", MFD_CLOEXEC));
  const FileDescriptor null(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const pid_t pid = fork();
  if (pid == 0) {
    setpgid(0, 0);
    signal(SIGPIPE, SIG_DFL);
    dup2(null.get(), STDIN_FILENO);
    dup2(out.get(), STDOUT_FILENO);
    dup2(err.get(), STDERR_FILENO);
    execvp(pointers[0], pointers.data());
    _exit(127);
  }
  ProgramOutput output;
  if (pid < 0) return output;
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) output.exit_code = WEXITSTATUS(status);
  output.standard = TextOf(out);
  output.errors = TextOf(err);
  return output;
}

}  // namespace shoal
