#include "lib/run/hosts/link_outbox.h"

namespace shoal {

bool LinkOutbox::Send(std::span<const uint8_t> bytes, const SendNow& send_now) {
  if (is_stuck_) return false;
  if (waiting_.empty()) {
    const Sent sent = send_now(bytes);
    if (sent != Sent::kLater) return sent == Sent::kYes;
  }
  if (waiting_bytes_ + bytes.size() > kMaxWaiting_bytes) {
    is_stuck_ = true;
    waiting_.clear();
    waiting_bytes_ = 0;
    return false;
  }
  waiting_bytes_ += bytes.size();
  waiting_.emplace_back(bytes.begin(), bytes.end());
  return true;
}

void LinkOutbox::SendWaiting(const SendNow& send_now) {
  while (!waiting_.empty() && send_now(waiting_.front()) != Sent::kLater) {
    waiting_bytes_ -= waiting_.front().size();
    waiting_.pop_front();
  }
}

}  // namespace shoal
