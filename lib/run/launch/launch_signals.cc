#include "lib/run/launch/launch_signals.h"

#include <signal.h>
#include <sys/signalfd.h>

namespace shoal {

int BlockSignals() {
  sigset_t set;
  sigemptyset(&set);
  signal(SIGCHLD, SIG_DFL);  // A parent that ignores it would hide the children's exits.
  for (const int number : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&set, number);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  // Under nohup, SIGHUP stays ignored. (SIGINT too is ignored in a script's background jobs, but
  // it is sent there on purpose.)
  if (hangup.sa_handler != SIG_IGN) sigaddset(&set, SIGHUP);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  signal(SIGPIPE, SIG_IGN);
  return signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
}

}  // namespace shoal
