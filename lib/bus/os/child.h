// Child processes: programs that are started, and copies of this process.
//
//   const Result<StartedProgram> started = StartProgram({.argv = {"gnuplot", "a.gp"}});
//   if (started.ok() && started->exec_error == 0) int status = WaitFor(started->pid);
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

/// Both ends of a pipe; not open if none could be made (errno). Children inherit neither.
struct Pipe {
  FileDescriptor read;
  FileDescriptor write;
};
[[nodiscard]] Pipe MakePipe();

/// What to start, and how. Of this process's descriptors the child has those that are named here.
struct ProgramStart {
  /// The program and its arguments. argv[0] without a slash is looked for on the PATH.
  std::vector<std::string> argv;
  /// "NAME=value", in place of a variable of that name or beside the inherited ones.
  std::vector<std::string> environment = {};
  std::string folder = {};  ///< Where it works; empty: where this process does.
  int input = -1;           ///< Standard input; -1, as for the next two: /dev/null.
  int output = -1;          ///< Standard output.
  int errors = -1;          ///< Standard error.
  int kept = -1;            ///< One descriptor more, which the child has under `kept_as` ...
  int kept_as = -1;         ///< ... or, if this is -1, under its own number.
  bool own_group = false;   ///< A process group of its own: Ctrl-C on the terminal is not for it.
  bool dies_with_parent = false;  ///< SIGKILL when the thread that started it ends.
};

struct StartedProgram {
  pid_t pid = 0;
  /// Why it could not be executed, as errno; 0: it runs. The child has ended with the exit code 127
  /// then, and is still to be waited for.
  int exec_error = 0;
};

/// Starts a program. Returns once it is executed, or could not be. An error states why there is no
/// new process.
[[nodiscard]] Result<StartedProgram> StartProgram(const ProgramStart& start);

/// Copies this process. Returns 0 in the copy, which a SIGKILL ends when the thread that made it
/// does; its number in the original, or -1 (errno).
[[nodiscard]] pid_t ForkWithParent();

/// Waits for the end of a child of this process. Returns its status, as waitpid() does.
int WaitFor(pid_t pid);

/// Returns "exited with code 3" or "was killed by signal 11 (Segmentation fault)".
[[nodiscard]] std::string HowItEnded(int status);

}  // namespace shoal
