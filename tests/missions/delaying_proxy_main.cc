// Carries TCP connections on loopback with a delay, until it is killed: for tests/bench/hosts.
//
//   delaying_proxy TARGET_PORT DELAY_MS
//
// Prints the port at which it listens. DELAY_MS: of each direction.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "tests/missions/delaying_proxy.h"

int main(int argc, char** argv) {
  const int target_port = argc == 3 ? std::atoi(argv[1]) : 0;
  const double delay_s = argc == 3 ? std::atof(argv[2]) / 1e3 : 0;
  if (target_port <= 0 || target_port > 65535 || delay_s < 0) {
    std::fprintf(stderr, "usage: delaying_proxy TARGET_PORT DELAY_MS\n");
    return 2;
  }
  const shoal::DelayingProxy proxy(target_port, delay_s);
  if (proxy.port() == 0) {
    std::fprintf(stderr, "delaying_proxy: no port on loopback can be listened at\n");
    return 3;
  }
  std::printf("%d\n", proxy.port());
  std::fflush(stdout);
  while (true) pause();
}
