// Several descriptors as one, for loops that wait for one.
//
//   WaitSet servers;
//   servers.Add(positions->fd());
//   servers.Add(modem->fd());
//   transport.Poll(timeout_us, servers.fd());
#pragma once

#include <sys/epoll.h>

#include "lib/bus/os/file_descriptor.h"

namespace shoal {

class WaitSet {
 public:
  WaitSet() : epoll_(epoll_create1(EPOLL_CLOEXEC)) {}

  /// Readable when one of those added is; negative where there were no descriptors left.
  int fd() const { return epoll_.get(); }

  /// False where `fd` cannot be waited for. It leaves by itself when it is closed.
  bool Add(int fd) {
    epoll_event event{.events = EPOLLIN, .data = {.fd = fd}};
    return epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, fd, &event) == 0;
  }

 private:
  FileDescriptor epoll_;
};

}  // namespace shoal
