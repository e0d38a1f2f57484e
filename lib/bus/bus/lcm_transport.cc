#include "lib/bus/bus/lcm_transport.h"

#include <fmt/format.h>

#include "lib/bus/bus/layout.h"
#include "lib/bus/bus/multicast_fault.h"

namespace shoal {

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
  const std::string fault = MulticastFault();  // liblcm would print a page about it.
  if (fault.empty()) sender->second = lcm_create(LcmUrl(port).c_str());
  if (sender->second == nullptr && error_.empty()) {
    error_ = fmt::format("cannot open LCM port {}: {}", port,
                         fault.empty() ? "liblcm refuses it; run `shoal doctor`" : fault);
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

bool LcmTransport::Poll(int64_t timeout_us, int extra_fd, WakeFor wake_for) {
  return lcm_receiver_.Poll(timeout_us, extra_fd, take_, wake_for);
}

void LcmTransport::Take(int port, std::string_view channel, std::span<const uint8_t> datagram) {
  if (channel == "LCM_SELF_TEST") return;  // liblcm's own.
  if (drop_ && drop_(channel)) return;
  receiver_(port, channel, datagram);
}

}  // namespace shoal
