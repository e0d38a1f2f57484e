#include "lib/run/multicast_fault.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>

#include "lib/record/file_descriptor.h"

namespace shoal {

namespace {

constexpr char kGroup[] = "239.255.76.67";
constexpr uint16_t kDiscardPort = 9;  ///< RFC 863; LCM programs have none below 1024.

std::string Fault(const char* what, int error) {
  return fmt::format(
      "multicast does not work on this machine: {} {}: {}. Most often this helps (`shoal doctor` "
      "looks for more):\n"
      "    sudo ip link set lo up multicast on && sudo ip route add 224.0.0.0/4 dev lo",
      what, kGroup, ErrnoText(error));
}

}  // namespace

std::string MulticastFault() {
  const FileDescriptor fd(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  if (!fd.is_open()) return fmt::format("no UDP socket can be opened: {}", ErrnoText(errno));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(kDiscardPort);
  inet_pton(AF_INET, kGroup, &address.sin_addr);
  ip_mreq membership{};
  membership.imr_multiaddr = address.sin_addr;
  const unsigned char ttl = 0;
  if (setsockopt(fd.get(), IPPROTO_IP, IP_MULTICAST_TTL, &ttl, sizeof ttl) != 0 ||
      setsockopt(fd.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) != 0) {
    return Fault("cannot join the group", errno);
  }
  if (sendto(fd.get(), nullptr, 0, 0, reinterpret_cast<const sockaddr*>(&address),
             sizeof address) != 0) {
    return Fault("cannot send to", errno);
  }
  return {};
}

}  // namespace shoal
