// The TCP port of the viewer's web server.
#pragma once

#include <string>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

struct ListeningOptions {
  std::string address = "127.0.0.1";  ///< A name or an IP address of this machine.
  int port = 8765;                    ///< 0: any.
  int last_port = 8765;               ///< The first free one from `port` to this is taken.
};

struct ListeningSocket {
  FileDescriptor fd;  ///< Non-blocking.
  int port = 0;
};

/// Listens, and shares the port with no other program. The error states what to try.
[[nodiscard]] Result<ListeningSocket> ListenOn(const ListeningOptions& options);

/// True for an address that only this machine can reach.
[[nodiscard]] bool IsLoopback(const std::string& address);

/// Returns "http://ADDRESS:PORT/", an IPv6 address in brackets, with `?token=` where there is one.
/// An address that stands for all of the machine's is shown as `host_name`.
[[nodiscard]] std::string PageUrl(const std::string& address, int port, const std::string& token,
                                  const std::string& host_name);

}  // namespace shoal
