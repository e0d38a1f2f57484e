#include "apps/shore_broker/media_writer.h"

#include "lib/media/relay_path.h"

namespace shoal {

MediaWriter::MediaWriter(Bus& bus) : bus_(bus) {
  message_.num_media = 0;
  message_.media.resize(kMaxPerMessage);
}

void MediaWriter::Add(int64_t utime, const Decision& decision, const Shipment& shipment,
                      const LegEnd& end) {
  const ShipmentLeg& leg = end.leg;
  if (message_.num_media == kMaxPerMessage) Flush(utime);
  fate_medium_t& fate = message_.media[static_cast<size_t>(message_.num_media++)];
  const RadioLink& radio = leg.medium.radio;
  fate.kind = KindText(decision.kind);
  fate.source = shipment.source;
  fate.destination = leg.destination;
  fate.number = decision.number;
  fate.cause = CauseText(decision.cause);
  fate.medium = leg.medium.name;
  fate.origin = shipment.provenance.origin;
  fate.hop = NumHops(shipment.provenance.via);
  fate.depth_m = radio.depth_m;
  fate.depth_limit_m = radio.depth_limit_m;
  fate.range_m = radio.range_m;
  fate.limit_m = radio.limit_m;
  fate.horizon_m = radio.horizon_m;
  fate.path_loss_db = radio.path_loss_db;
  fate.path_loss_limit_db = radio.path_loss_limit_db;
  fate.loss_probability = leg.medium.loss_probability;
  fate.delay_s = leg.medium.delay_s;
  if (end.reception != nullptr) {
    fate.range_m = end.reception->range_m;
    if (end.reception->travel_s >= 0) fate.delay_s = end.reception->end_s - end.reception->sent_s;
  }
}

void MediaWriter::Flush(int64_t utime) {
  if (message_.num_media == 0) return;
  message_.utime = utime;
  Publish(bus_, channel_, message_);
  message_.num_media = 0;
}

}  // namespace shoal
