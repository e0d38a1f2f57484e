// Runs the rest of a program in a child process and watches over it. mpirun ends with 137 where a
// rank is killed, and names neither the host nor what is to be done; a parent that outlives its
// rank ends with shoal's own code for a process that is lost.
#pragma once

#include <functional>

namespace shoal {

/// Calls `run` in a child process and returns its exit code; kExitEnvironment, with an error on
/// standard error that names the rank, where a signal ended it. Signals that ask to end are handed
/// on to it, and it dies with this process.
/// @pre no thread was started
int RunWatched(const std::function<int()>& run);

}  // namespace shoal
