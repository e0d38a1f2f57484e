#include "lib/bus/bus/multicast_fault.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "lib/bus/bus/layout.h"

namespace shoal {

namespace {

constexpr uint16_t kDiscardPort = 9;  ///< RFC 863; LCM programs have none below 1024.

std::string Fault(const char* what, int error) {
  return fmt::format(
      "multicast does not work on this machine: {} {}: {}. Most often this helps (`shoal doctor` "
      "looks for more):\n"
      "    sudo ip link set lo up multicast on && sudo ip route add 224.0.0.0/4 dev lo",
      what, kLcmGroup, std::strerror(error));
}

/// `opened`: a UDP socket.
std::string FaultOf(int opened) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(kDiscardPort);
  inet_pton(AF_INET, kLcmGroup, &address.sin_addr);
  ip_mreq membership{};
  membership.imr_multiaddr = address.sin_addr;
  const unsigned char ttl = 0;
  if (setsockopt(opened, IPPROTO_IP, IP_MULTICAST_TTL, &ttl, sizeof ttl) != 0 ||
      setsockopt(opened, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) != 0) {
    return Fault("cannot join the group", errno);
  }
  if (sendto(opened, nullptr, 0, 0, reinterpret_cast<const sockaddr*>(&address), sizeof address) !=
      0) {
    return Fault("cannot send to", errno);
  }
  return {};
}

}  // namespace

std::string MulticastFault() {
  const int opened = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (opened < 0) return fmt::format("no UDP socket can be opened: {}", std::strerror(errno));
  std::string fault = FaultOf(opened);
  close(opened);
  return fault;
}

}  // namespace shoal
