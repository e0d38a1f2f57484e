#include "apps/viewer/listening_socket.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <memory>

namespace shoal {

namespace {

/// Connections that the kernel keeps until they are accepted: a browser that opens ten pages at
/// once, or many clients that do not read, must not be refused.
constexpr int kBacklog = 512;

/// Binds `address` with its port set. Returns the socket, closed where that failed (errno).
FileDescriptor Bind(const addrinfo& address, int port) {
  FileDescriptor fd(
      socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, IPPROTO_TCP));
  if (!fd.is_open()) return fd;
  // A viewer that is started again must not wait for the connections of the one before. (Not
  // SO_REUSEPORT: two viewers would share a port, and a browser would reach one or the other.)
  const int on = 1;
  setsockopt(fd.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_storage storage{};
  std::copy_n(reinterpret_cast<const char*>(address.ai_addr), address.ai_addrlen,
              reinterpret_cast<char*>(&storage));
  const auto number = htons(static_cast<uint16_t>(port));
  if (address.ai_family == AF_INET6) {
    reinterpret_cast<sockaddr_in6*>(&storage)->sin6_port = number;
  } else {
    reinterpret_cast<sockaddr_in*>(&storage)->sin_port = number;
  }
  if (bind(fd.get(), reinterpret_cast<const sockaddr*>(&storage), address.ai_addrlen) == 0 &&
      listen(fd.get(), kBacklog) == 0) {
    return fd;
  }
  const int error = errno;
  fd = FileDescriptor();
  errno = error;
  return FileDescriptor();
}

int PortOf(int fd) {
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  if (getsockname(fd, reinterpret_cast<sockaddr*>(&storage), &size) != 0) return 0;
  return ntohs(storage.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6*>(&storage)->sin6_port
                                             : reinterpret_cast<sockaddr_in*>(&storage)->sin_port);
}

}  // namespace

Result<ListeningSocket> ListenOn(const ListeningOptions& options) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  if (const int code = getaddrinfo(options.address.c_str(), nullptr, &hints, &found); code != 0) {
    return Error{
        fmt::format("--listen {}: {}; give an IP address of this machine, 0.0.0.0 for all of them",
                    options.address, gai_strerror(code))};
  }
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> addresses(found, &freeaddrinfo);
  int error = 0;
  for (int port = options.port; port <= options.last_port; ++port) {
    FileDescriptor fd = Bind(*addresses, port);
    if (fd.is_open()) {
      const int bound = PortOf(fd.get());
      return ListeningSocket{.fd = std::move(fd), .port = bound};
    }
    error = errno;
    if (error != EADDRINUSE) break;
  }
  if (error != EADDRINUSE) {
    return Error{fmt::format(
        "cannot listen on {}, TCP port {}: {}{}", options.address, options.port, ErrnoText(error),
        error == EADDRNOTAVAIL ? "; give an address that this machine has (`ip address` lists "
                                 "them), 0.0.0.0 for all of them"
                               : "")};
  }
  if (options.last_port > options.port) {
    return Error{fmt::format("TCP ports {} to {} are all taken; give a free one with --http",
                             options.port, options.last_port)};
  }
  return Error{fmt::format(
      "TCP port {0} is taken (`ss -tlnp 'sport = :{0}'` shows by which program); choose another "
      "with --http (`shoal run`: --view-http), or leave it out",
      options.port)};
}

bool IsLoopback(const std::string& address) {
  in_addr v4{};
  if (inet_pton(AF_INET, address.c_str(), &v4) == 1) return (ntohl(v4.s_addr) >> 24) == 127;
  return address == "localhost" || address == "::1";
}

std::string PageUrl(const std::string& address, int port, const std::string& token,
                    const std::string& host_name) {
  const bool is_any = address == "0.0.0.0" || address == "::";
  std::string host = is_any ? host_name : address;
  if (host.find(':') != std::string::npos) host = fmt::format("[{}]", host);
  return fmt::format("http://{}:{}/{}", host, port, token.empty() ? "" : "?token=" + token);
}

}  // namespace shoal
