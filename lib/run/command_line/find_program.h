// Where programs are: shoal's own, which lie beside each other, those of missions, and others.
#pragma once

#include <string>
#include <string_view>

#include "lib/base/check/result.h"

namespace shoal {

/// Returns the folder of the running executable.
std::string ExecutableDirectory();

/// Looks for a program: with a '/', from the current folder, the mission file's or shoal's own;
/// without, beside shoal, then on the PATH. The error names it and the places, or, of a program of
/// shoal, what provides it.
[[nodiscard]] Result<std::string> FindProgram(const std::string& program,
                                              const std::string& mission_file);

/// Looks for a program of shoal beside the running one only: on the PATH there may be one of
/// another version. The error states what provides it.
[[nodiscard]] Result<std::string> FindBeside(const std::string& program);

/// Returns what provides a program of shoal that is missing: in a build folder "is not built: cmake
/// --build build --target helm", elsewhere that the installation lacks it.
/// @pre ExecutableDirectory() has no such program
[[nodiscard]] std::string WhyMissing(const std::string& program);

/// Returns the first executable file called `name` in the folders of `search_path`, which is
/// written as PATH is; empty: there is none. Empty folders, which would mean the current one, do
/// not count.
[[nodiscard]] std::string FindExecutable(std::string_view name, std::string_view search_path);

}  // namespace shoal
