#include "apps/shore_broker/received_memory.h"

#include <algorithm>

#include "lib/routing/vehicle_name.h"

namespace shoal {

bool ReceivedMemory::Take(Kind kind, std::string_view origin, int64_t number,
                          std::string_view receiver, bool is_forwarded) {
  std::string from = VehicleKey(origin);
  std::string to = VehicleKey(receiver);
  if (kind == Kind::kReport) {
    const auto [last, is_first] = last_reports_.try_emplace({from, to}, number);
    if (is_first) return true;
    if (is_forwarded ? number <= last->second : number == last->second) return false;
    last->second = std::max(last->second, number);
    return true;
  }
  const auto [seen, is_new] = seen_.emplace(kind, std::move(from), number, std::move(to));
  if (!is_new) return false;
  recent_.push_back(*seen);
  if (recent_.size() > kRemembered) {
    seen_.erase(recent_.front());
    recent_.pop_front();
  }
  return true;
}

}  // namespace shoal
