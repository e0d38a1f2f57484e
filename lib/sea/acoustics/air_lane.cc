#include "lib/sea/acoustics/air_lane.h"

#include "lib/base/check/check.h"

namespace shoal {

AirLane::Ticket AirLane::Start(const Packet& packet) {
  SHOAL_CHECK(packet.start_s < packet.end_s, "start_s < end_s");
  SHOAL_CHECK(kept_.empty() || kept_.back().packet.start_s <= packet.start_s,
              "packets start in order of time");
  kept_.push_back({packet, false});
  return {num_started_++, num_on_air_++};
}

void AirLane::End(const Ticket& ticket, std::vector<int32_t>* unneeded) {
  kept_[static_cast<size_t>(ticket.position - first_kept_)].has_ended = true;
  --num_on_air_;
  while (first_on_air_ < num_started_ && At(first_on_air_).has_ended) ++first_on_air_;
  if (num_on_air_ == 0) {
    Forget(num_started_, unneeded);
    return;
  }
  // Of the packets on the air this one started first; nothing that ended before overlaps any.
  const double oldest_start_s = At(first_on_air_).packet.start_s;
  int64_t end = forgotten_;
  while (end < first_on_air_ && At(end).packet.end_s <= oldest_start_s) ++end;
  Forget(end, unneeded);
}

void AirLane::Forget(int64_t end, std::vector<int32_t>* unneeded) {
  for (; forgotten_ < end; ++forgotten_) unneeded->push_back(At(forgotten_).packet.transmission);
  const int64_t num_forgotten = forgotten_ - first_kept_;
  // Moving what is left only when it is the smaller part keeps the cost per packet constant.
  if (2 * num_forgotten < static_cast<int64_t>(kept_.size())) return;
  kept_.erase(kept_.begin(), kept_.begin() + num_forgotten);
  first_kept_ = forgotten_;
}

}  // namespace shoal
