#include "apps/netsim_manager/epoll_set.h"

#include <sys/epoll.h>

namespace shoal {

EpollSet::EpollSet() : epoll_(epoll_create1(EPOLL_CLOEXEC)) {}

bool EpollSet::Add(int fd) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = fd;
  return epoll_.get() >= 0 && epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, fd, &event) == 0;
}

}  // namespace shoal
