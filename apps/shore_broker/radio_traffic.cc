#include "apps/shore_broker/radio_traffic.h"

#include <cmath>

namespace shoal {

void RadioTraffic::Send(std::shared_ptr<const Shipment> shipment, ShipmentLeg leg,
                        const RadioOptions& options, const RadioDraw& draw, int64_t sent_utime) {
  const RadioPassage passage =
      DrawPassage(options, static_cast<int64_t>(shipment->payload.size()), draw);
  leg.medium.delay_s = passage.delay_s;
  leg.medium.loss_probability = options.loss;
  const int64_t arrives_utime = sent_utime + std::llround(passage.delay_s * 1e6);
  under_way_.emplace(std::pair(arrives_utime, num_sent_++),
                     UnderWay{.shipment = std::move(shipment),
                              .leg = std::move(leg),
                              .sent_utime = sent_utime,
                              .is_lost = passage.is_lost});
}

void RadioTraffic::Deliver(int64_t utime, const TakeLegEnd& take) {
  while (!under_way_.empty() && under_way_.begin()->first.first <= utime) {
    const auto node = under_way_.extract(under_way_.begin());
    const UnderWay& arrived = node.mapped();
    take({.shipment = *arrived.shipment,
          .leg = arrived.leg,
          .cause = arrived.is_lost ? Cause::kPacketLoss : Cause::kDelivered,
          .payload = arrived.is_lost ? std::span<const uint8_t>()
                                     : std::span<const uint8_t>(arrived.shipment->payload),
          .sent_utime = arrived.sent_utime,
          .arrived_utime = node.key().first});
  }
}

std::optional<int64_t> RadioTraffic::NextUtime() const {
  if (under_way_.empty()) return std::nullopt;
  return under_way_.begin()->first.first;
}

}  // namespace shoal
