// Several descriptors as one, for an app that serves more than one listener.
//
//   EpollSet set;
//   set.Add(server.fd());
//   transport.Poll(timeout_us, set.fd());   // Readable when one of them is.
#pragma once

#include "lib/record/file_descriptor.h"

namespace shoal {

class EpollSet {
 public:
  EpollSet();

  /// Returns false where the kernel has no room for one more.
  bool Add(int fd);
  /// Level-triggered: readable for as long as one of them is.
  int fd() const { return epoll_.get(); }

 private:
  FileDescriptor epoll_;
};

}  // namespace shoal
