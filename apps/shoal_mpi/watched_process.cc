#include "apps/shoal_mpi/watched_process.h"

#include <fmt/format.h>
#include <signal.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "lib/base/check/result.h"
#include "lib/bus/os/child.h"

namespace shoal {

namespace {

volatile sig_atomic_t watched = 0;  ///< The child's process number.

void HandOn(int signal) {
  if (watched != 0) kill(watched, signal);
}

/// Returns this process's rank as whatever started it has it in the environment.
std::string RankText() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"}) {
    if (const char* rank = std::getenv(name)) return fmt::format("rank {}", rank);
  }
  return "the only rank";
}

}  // namespace

int RunWatched(const std::function<int()>& run) {
  const pid_t child = ForkWithParent();
  if (child < 0) {
    fmt::print(stderr, "shoal-mpi: cannot start a process: {}\n", strerror(errno));
    return kExitEnvironment;
  }
  if (child == 0) return run();
  watched = child;
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2}) {
    signal(signal_number, HandOn);
  }
  const int status = WaitFor(child);
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  char host[256] = {};
  gethostname(host, sizeof host - 1);
  fmt::print(stderr, "shoal-mpi: LOST: {} (host {}, process {}) was killed by signal {} ({})\n",
             RankText(), host, child, WTERMSIG(status), strsignal(WTERMSIG(status)));
  return kExitEnvironment;
}

}  // namespace shoal
