#include "apps/shore_broker/repeat_memory.h"

namespace shoal {

bool RepeatMemory::IsRepeat(std::string_view source_key, std::string_view ack_id) {
  constexpr size_t kBytesThatCount = 100;
  std::pair<std::string, std::string> message(source_key, ack_id.substr(0, kBytesThatCount));
  if (!seen_.insert(message).second) return true;
  recent_.push_back(std::move(message));
  if (recent_.size() > kRemembered) {
    seen_.erase(recent_.front());
    recent_.pop_front();
  }
  return false;
}

}  // namespace shoal
