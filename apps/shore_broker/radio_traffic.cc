#include "apps/shore_broker/radio_traffic.h"

#include <cmath>

#include "lib/base/time/seconds.h"

namespace shoal {

void RadioTraffic::Send(std::shared_ptr<const Shipment> shipment, ShipmentLeg leg,
                        const RadioOptions& options, const RadioDraws& draws, int64_t sent_utime) {
  const RadioPassage passage =
      DrawPassage(options, static_cast<int64_t>(shipment->payload.size()), draws, shipment->number);
  leg.medium.delay_s = passage.delay_s;
  leg.medium.loss_probability = options.loss;
  size_t slot = under_way_.size();
  if (free_slots_.empty()) {
    under_way_.emplace_back();
  } else {
    slot = free_slots_.back();
    free_slots_.pop_back();
  }
  UnderWay& under_way = under_way_[slot];
  under_way.shipment = std::move(shipment);
  under_way.leg = std::move(leg);
  under_way.sent_utime = sent_utime;
  under_way.is_lost = passage.is_lost;
  queue_.push(
      {.utime = sent_utime + Microseconds(passage.delay_s), .order = num_sent_++, .slot = slot});
}

void RadioTraffic::Deliver(int64_t utime, const TakeLegEnd& take) {
  while (!queue_.empty() && queue_.top().utime <= utime) {
    const Arrival arrival = queue_.top();
    queue_.pop();
    UnderWay& arrived = under_way_[arrival.slot];
    take({.shipment = *arrived.shipment,
          .leg = arrived.leg,
          .cause = arrived.is_lost ? Cause::kPacketLoss : Cause::kDelivered,
          .payload = arrived.is_lost ? std::span<const uint8_t>()
                                     : std::span<const uint8_t>(arrived.shipment->payload),
          .sent_utime = arrived.sent_utime,
          .arrived_utime = arrival.utime});
    arrived.shipment.reset();
    free_slots_.push_back(arrival.slot);
  }
}

std::optional<int64_t> RadioTraffic::NextUtime() const {
  if (queue_.empty()) return std::nullopt;
  return queue_.top().utime;
}

}  // namespace shoal
