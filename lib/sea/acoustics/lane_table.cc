#include "lib/sea/acoustics/lane_table.h"

namespace shoal {

namespace {

/// Idle lanes are not looked for before there are this many.
constexpr size_t kMinIdleLanes = 1024;

}  // namespace

int32_t LaneTable::FindOrOpen(int32_t receiver, int32_t channel, size_t num_in_transit) {
  const uint64_t key = static_cast<uint64_t>(receiver) << 32 | static_cast<uint32_t>(channel);
  const auto found = lane_of_.find(key);
  if (found != lane_of_.end()) return found->second;
  if (lane_of_.size() > kMinIdleLanes + 2 * num_in_transit) CloseIdle();
  return lane_of_[key] = lanes_.Take();
}

void LaneTable::CloseIdle() {
  std::erase_if(lane_of_, [this](const auto& entry) {
    const bool is_idle = lanes_[entry.second].IsIdle();
    if (is_idle) lanes_.Free(entry.second);
    return is_idle;
  });
}

}  // namespace shoal
