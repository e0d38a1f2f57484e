#include "lib/bus/lcm_transport.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "lib/bus/layout.h"

namespace shoal {

namespace {

/// Returns 0 where the kernel has a route to LCM's group, otherwise the error number. liblcm would
/// print pages about it.
int MulticastTrouble(int port) {
  const int opened = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (opened < 0) return errno;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = inet_addr(kLcmGroup);
  const int trouble =
      connect(opened, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ? 0 : errno;
  close(opened);
  return trouble;
}

}  // namespace

LcmTransport::LcmTransport(FilterPlace place)
    : lcm_receiver_(place),
      take_([this](int port, std::string_view channel, std::span<const uint8_t> datagram) {
        Take(port, channel, datagram);
      }) {}

LcmTransport::~LcmTransport() {
  for (const auto& [port, lcm] : senders_) {
    if (lcm != nullptr) lcm_destroy(lcm);
  }
}

lcm_t* LcmTransport::Open(int port) {
  const auto [sender, is_new] = senders_.try_emplace(port, nullptr);
  if (!is_new) return sender->second;
  const int trouble = MulticastTrouble(port);
  if (trouble == 0) sender->second = lcm_create(LcmUrl(port).c_str());
  if (sender->second == nullptr && error_.empty()) {
    error_ =
        fmt::format("cannot open LCM port {} ({}): {}", port,
                    trouble == 0 ? "liblcm refuses" : std::strerror(trouble), kMulticastRemedy);
  }
  return sender->second;
}

void LcmTransport::Send(int port, std::string_view channel, std::span<const uint8_t> datagram) {
  lcm_t* lcm = Open(port);
  // What fails here is lost like any datagram: the step protocol asks for it again, or gives up.
  const bool is_sent =
      lcm != nullptr && lcm_publish(lcm, std::string(channel).c_str(), datagram.data(),
                                    static_cast<unsigned>(datagram.size())) == 0;
  if (!is_sent) ++num_failed_sends_;
}

bool LcmTransport::Poll(int64_t timeout_us, int extra_fd) {
  return lcm_receiver_.Poll(timeout_us, extra_fd, take_);
}

void LcmTransport::Take(int port, std::string_view channel, std::span<const uint8_t> datagram) {
  if (channel == "LCM_SELF_TEST") return;  // liblcm's own.
  if (drop_ && drop_(channel)) return;
  receiver_(port, channel, datagram);
}

}  // namespace shoal
