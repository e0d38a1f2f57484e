// Runs a short program to its end and takes what it prints.
#pragma once

#include <string>
#include <vector>

namespace shoal {

struct ProgramOutput {
  int exit_code = -1;    ///< 127: it could not be executed. -1: it was killed by a signal.
  std::string standard;  ///< Standard output.
  std::string errors;    ///< Standard error.
};

/// Runs argv[0], looked for on the PATH, in a process group of its own: Ctrl-C on the terminal does
/// not reach it.
[[nodiscard]] ProgramOutput RunProgram(const std::vector<std::string>& argv);

}  // namespace shoal
