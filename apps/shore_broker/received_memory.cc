#include "apps/shore_broker/received_memory.h"

#include <algorithm>

#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

bool ReceivedMemory::Take(Kind kind, std::string_view origin, int64_t number,
                          std::string_view receiver, bool is_forwarded) {
  std::string from = VehicleKey(origin);
  std::string to = VehicleKey(receiver);
  int64_t* last_report = nullptr;
  if (kind == Kind::kReport) {
    last_report = &last_reports_.try_emplace({from, to}, -1).first->second;
    if (is_forwarded && number <= *last_report) return false;
  }
  const auto [seen, is_new] = seen_.emplace(kind, std::move(from), number, std::move(to));
  if (!is_new) return false;
  if (last_report != nullptr) *last_report = std::max(*last_report, number);
  recent_.push_back(*seen);
  if (recent_.size() > kRemembered) {
    seen_.erase(recent_.front());
    recent_.pop_front();
  }
  return true;
}

}  // namespace shoal
