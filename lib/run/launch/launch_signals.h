// The signals of a process that starts others.
#pragma once

namespace shoal {

/// Routes SIGINT, SIGTERM, SIGHUP and SIGCHLD to a descriptor, a signalfd that never waits, and
/// ignores SIGPIPE. To be called before LCM and ZeroMQ make their threads, which inherit the mask.
int BlockSignals();

}  // namespace shoal
