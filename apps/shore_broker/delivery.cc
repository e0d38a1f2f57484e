#include "apps/shore_broker/delivery.h"

#include <algorithm>
#include <cmath>

#include "apps/shore_broker/air_text.h"
#include "lib/base/check/check.h"
#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/sea/media/relay_path.h"

namespace shoal {

namespace {

/// acoustic_path_t: without a modem there is no such number.
constexpr double kNoSnr_db = -999;

/// Returns the channel on which `vehicle` receives traffic of this kind.
std::string ChannelOf(Kind kind, std::string_view vehicle) {
  switch (kind) {
    case Kind::kReport:
      return channels::NodeReport(vehicle).name;
    case Kind::kMessage:
      return channels::NodeMessage(vehicle).name;
    case Kind::kAck:
      return channels::AckMessageTo(vehicle).name;
    case Kind::kPacket:
      break;
  }
  return channels::AcousticRx(vehicle).name;
}

/// @pre it went over an acoustic network
acoustic_path_t PathOf(const LegEnd& arrival) {
  const Reception& reception = *arrival.reception;
  const AcousticTraffic& traffic = *arrival.acoustic;
  acoustic_path_t path;
  path.packet = reception.packet.number;
  path.channel = traffic.ChannelId(reception.channel);
  path.sent_utime = arrival.sent_utime;
  path.num_bytes = traffic.FrameBytes(arrival.shipment);
  path.air_s = reception.air_s;
  path.travel_s = reception.travel_s;
  path.jitter_s = reception.jitter_s;
  path.snr_db = reception.snr_db.value_or(kNoSnr_db);
  path.loss_probability = reception.loss_probability;
  path.bit_error_probability = reception.bit_error_probability;
  path.bits_flipped = reception.num_bits_flipped;
  path.num_colliders = static_cast<int32_t>(reception.num_colliders);
  path.own_packet = reception.own_number;
  path.num_named =
      static_cast<int32_t>(std::clamp<int64_t>(reception.num_colliders, 0, kMaxNamedColliders));
  for (int i = 0; i < path.num_named; ++i) {
    path.colliders.push_back(traffic.NameOf(reception.colliders[static_cast<size_t>(i)]));
  }
  return path;
}

}  // namespace

void Delivery::Conclude(int64_t utime, const DecidedTransmission& sent) {
  // What is delivered goes out before its fates are published.
  for (const Decision& decision : sent.decisions) {
    if (decision.cause != Cause::kDelivered) continue;
    const ReceiverChannels& receiver = ChannelsOf(decision.destination);
    bus_.PublishBytes(receiver.names[static_cast<size_t>(decision.kind)], sent.raw);
  }
  bool any_in_transit = false;
  for (const Decision& decision : sent.decisions) {
    if (decision.cause == Cause::kInTransit) {
      any_in_transit = true;
      continue;
    }
    const bool has_contact = decision.destination >= 0;
    const std::string_view source = decision.source == kNoContact
                                        ? sent.written_source
                                        : std::string_view(router_.contact(decision.source).name);
    std::string written;
    if (decision.unknown_name >= 0) {
      written = Printable(sent.unknown_names[static_cast<size_t>(decision.unknown_name)]);
    }
    fates_.Add(utime, decision, source,
               has_contact ? std::string_view(router_.contact(decision.destination).name)
                           : std::string_view(written));
    if (decision.cause != Cause::kDelivered || !sent.has_pulses) continue;
    const Contact& receiver = router_.contact(decision.destination);
    pulses_.Add(utime,
                {.source = source,
                 .destination = receiver.name,
                 .contact = decision.destination,
                 .from_m = sent.from_m,
                 .to_m = receiver.position_m,
                 .range_m = decision.range_m,
                 .of_message = decision.kind != Kind::kReport,
                 .color = sent.color},
                router_.rules().pulse_duration_s);
  }
  if (any_in_transit) SendOverMedia(utime, sent);
}

void Delivery::SendOverMedia(int64_t utime, const DecidedTransmission& sent) {
  if (const std::string& problem = traffic_.acoustic().problem();
      !problem.empty() && sent.over->Has(kAcousticMedium)) {
    log_.Warn("no vehicle can send over the acoustic network; [acoustics] " + problem);
  }
  Shipment shipment;
  shipment.message.assign(sent.raw.begin(), sent.raw.end());
  shipment.payload = sent.air_bytes();
  shipment.data_rate_bps = sent.data_rate_bps;
  shipment.channel = sent.channel;
  shipment.from_m = sent.from_m;
  shipment.has_pulses = sent.has_pulses;
  shipment.color = sent.color;
  shipment.provenance = sent.provenance;
  shipment.legs.reserve(sent.decisions.size());
  for (const Decision& decision : sent.decisions) {
    if (decision.cause != Cause::kInTransit) continue;
    if (shipment.legs.empty()) {  // All are of one transmission.
      shipment.kind = decision.kind;
      shipment.number = decision.number;
      shipment.source = router_.contact(decision.source).name;
    }
    ShipmentLeg& leg = shipment.legs.emplace_back();
    leg.decision = decision;
    leg.destination = router_.contact(decision.destination).name;
  }
  if (shipment.provenance.origin.empty()) {
    shipment.provenance.origin = shipment.source;
    shipment.provenance.number = shipment.number;
  }
  EndWhereItWas(utime, &shipment);
  traffic_.Send(utime, std::move(shipment), *sent.over,
                [&](const LegEnd& end) { TakeLegEnd(utime, end); });
}

void Delivery::EndWhereItWas(int64_t utime, Shipment* shipment) {
  const Provenance& provenance = shipment->provenance;
  if (provenance.via.empty()) return;
  const auto was_there = [&](const ShipmentLeg& leg) {
    return VehicleKey(leg.destination) == VehicleKey(provenance.origin) ||
           IsVia(provenance.via, leg.destination);
  };
  for (const ShipmentLeg& leg : shipment->legs) {
    if (!was_there(leg)) continue;
    Conclude(utime, {.shipment = *shipment, .leg = leg, .cause = Cause::kAlreadyReceived},
             Cause::kAlreadyReceived);
  }
  std::erase_if(shipment->legs, was_there);
}

void Delivery::TakeArrivals(int64_t utime) {
  traffic_.Deliver(utime, [&](const LegEnd& end) { TakeLegEnd(utime, end); });
  SHOAL_CHECK(router_.NumInTransit() == traffic_.num_in_transit(),
              "router and media have the same number in transit");
}

void Delivery::Flush(int64_t utime) {
  fates_.Flush(utime);
  media_.Flush(utime);
  arrivals_.Flush(utime);
  pulses_.Flush(utime);
}

void Delivery::TakeLegEnd(int64_t utime, const LegEnd& end) {
  const Shipment& shipment = end.shipment;
  const std::string& destination = end.leg.destination;
  const bool is_overheard = end.leg.decision.is_overheard;
  Cause cause = end.cause;
  // A gateway received a message that is for another vehicle, and does not forward it: it is lost.
  const bool is_thrown_away =
      is_overheard && cause == Cause::kDelivered && ForwarderOf(end) == nullptr;
  if (is_thrown_away) {
    cause = Cause::kNoMedium;
  } else if (has_gateways_ && cause == Cause::kDelivered && shipment.kind != Kind::kPacket) {
    const Provenance& provenance = shipment.provenance;
    const bool is_new = received_.Take(shipment.kind, provenance.origin, provenance.number,
                                       destination, !provenance.via.empty());
    if (!is_new) cause = Cause::kAlreadyReceived;
  }
  if (cause == Cause::kDamaged && (is_overheard || !DeliverDamaged(utime, end))) {
    cause = Cause::kRejected;
  } else if (cause == Cause::kDelivered && shipment.kind == Kind::kPacket) {
    DeliverPacket(utime, end);
  } else if (cause == Cause::kDelivered) {
    if (!is_overheard) Deliver(end.leg, shipment);
    HandToGateway(utime, end);
  }
  // The network handed over what a checksum, or the receiver, then threw away.
  const bool was_handed_over = end.reception != nullptr && HandsOver(end.reception->fate);
  if (was_handed_over && !IsReceived(cause) && cause != Cause::kAlreadyReceived &&
      !is_thrown_away) {
    end.acoustic->CountRejection();
  }
  Conclude(utime, end, cause);
}

void Delivery::Deliver(const ShipmentLeg& leg, const Shipment& shipment) {
  const int32_t index = leg.decision.destination;
  if (index >= 0 && router_.contact(index).name == leg.destination) {
    const ReceiverChannels& receiver = ChannelsOf(index);
    bus_.PublishBytes(receiver.names[static_cast<size_t>(shipment.kind)], shipment.message);
  } else {
    bus_.PublishBytes(ChannelOf(shipment.kind, leg.destination), shipment.message);
  }
}

void Delivery::Conclude(int64_t utime, const LegEnd& end, Cause cause) {
  const Shipment& shipment = end.shipment;
  const std::string& destination = end.leg.destination;
  const Decision concluded =
      router_.Conclude(end.leg.decision, shipment.source, destination, cause);
  if (end.reception != nullptr) {
    const acoustic_path_t path = PathOf(end);
    fates_.Add(utime, concluded, shipment.source, destination, &path);
  } else {
    fates_.Add(utime, concluded, shipment.source, destination);
  }
  if (traffic_.has_media()) media_.Add(utime, concluded, shipment, end);
  if (end.reception != nullptr && end.reception->rays) {
    arrivals_.Add(utime, concluded, shipment, end);
  }
  if (!IsReceived(cause) || !shipment.has_pulses) return;
  pulses_.Add(utime,
              {.source = shipment.source,
               .destination = destination,
               .from_m = shipment.from_m,
               .to_m = end.leg.to_m,
               .range_m = end.reception != nullptr ? end.reception->range_m
                                                   : (end.leg.to_m - shipment.from_m).norm(),
               .of_message = shipment.kind != Kind::kReport,
               .color = shipment.color},
              router_.rules().pulse_duration_s);
}

const GatewayOptions* Delivery::ForwarderOf(const LegEnd& arrival) const {
  const GatewayOptions* gateway =
      has_gateways_ ? traffic_.GatewayAt(arrival.leg.destination) : nullptr;
  if (gateway == nullptr) return nullptr;
  const bool is_wanted =
      arrival.shipment.kind == Kind::kReport ? gateway->reports : gateway->messages;
  const bool is_from =
      std::ranges::find(gateway->from, arrival.leg.medium.name) != gateway->from.end();
  return is_wanted && is_from ? gateway : nullptr;
}

void Delivery::HandToGateway(int64_t utime, const LegEnd& arrival) {
  if (ForwarderOf(arrival) == nullptr) return;
  const std::string& destination = arrival.leg.destination;
  const Shipment& shipment = arrival.shipment;
  relay_t relay;
  relay.utime = utime;
  relay.gateway = destination;
  relay.kind = KindText(shipment.kind);
  relay.origin = shipment.provenance.origin;
  relay.number = shipment.provenance.number;
  relay.made_utime = shipment.provenance.made_utime;
  relay.from = shipment.source;
  relay.medium = arrival.leg.medium.name;
  relay.via = shipment.provenance.via;
  relay.num_media = 0;
  relay.data = shipment.message;
  relay.num_bytes = static_cast<int32_t>(relay.data.size());
  Publish(bus_, channels::RelayRx(destination), relay);
}

bool Delivery::DeliverDamaged(int64_t utime, const LegEnd& arrival) {
  const Shipment& shipment = arrival.shipment;
  const std::string& destination = arrival.leg.destination;
  const auto publish = [&](const auto& channel, const auto& understood) {
    if (!understood) return false;
    Publish(bus_, channel, *understood);
    return true;
  };
  const auto decode = [&](auto* message) {
    SHOAL_CHECK(Decode(shipment.message, message),
                "a message that was decoded on arrival decodes again");
  };
  switch (shipment.kind) {
    case Kind::kReport:
      decode(&report_);
      return publish(channels::NodeReport(destination),
                     UnderstandDamaged(report_, shipment.payload, arrival.payload,
                                       {.receiver = destination,
                                        .start_utime = setup_.start_utime,
                                        .now_utime = utime,
                                        .origin = setup_.origin,
                                        .vehicle_at = [&](uint32_t address) {
                                          return arrival.acoustic->VehicleAt(address);
                                        }}));
    case Kind::kMessage:
      decode(&message_);
      return publish(channels::NodeMessage(destination),
                     UnderstandDamaged(message_, arrival.payload));
    case Kind::kAck:
      decode(&ack_);
      return publish(channels::AckMessageTo(destination), UnderstandDamaged(ack_, arrival.payload));
    case Kind::kPacket:
      break;
  }
  DeliverPacket(utime, arrival);
  return true;
}

void Delivery::DeliverPacket(int64_t utime, const LegEnd& arrival) {
  acoustic_rx_t message;
  message.utime = utime;
  message.source = arrival.shipment.source;
  message.number = arrival.shipment.number;
  message.sent_utime = arrival.sent_utime;
  message.arrived_utime = arrival.arrived_utime;
  message.num_bytes = static_cast<int32_t>(arrival.payload.size());
  message.payload.assign(arrival.payload.begin(), arrival.payload.end());
  Publish(bus_, channels::AcousticRx(arrival.leg.destination), message);
  if (!arrival.shipment.channel || arrival.acoustic == nullptr) return;
  acoustic_rx_on_t on_channel;
  on_channel.utime = message.utime;
  on_channel.source = std::move(message.source);
  on_channel.channel = arrival.acoustic->ChannelId(arrival.reception->channel);
  on_channel.number = message.number;
  on_channel.sent_utime = message.sent_utime;
  on_channel.arrived_utime = message.arrived_utime;
  on_channel.num_bytes = message.num_bytes;
  on_channel.payload = std::move(message.payload);
  Publish(bus_, channels::AcousticRxOn(arrival.leg.destination), on_channel);
}

const Delivery::ReceiverChannels& Delivery::ChannelsOf(int32_t index) {
  const auto place = static_cast<size_t>(index);
  if (place >= receiver_channels_.size()) receiver_channels_.resize(place + 1);
  ReceiverChannels& receiver = receiver_channels_[place];
  const std::string& vehicle = router_.contact(index).name;
  if (receiver.vehicle != vehicle) {
    receiver.vehicle = vehicle;
    for (int kind = 0; kind < kNumKinds; ++kind) {
      receiver.names[static_cast<size_t>(kind)] = ChannelOf(static_cast<Kind>(kind), vehicle);
    }
  }
  return receiver;
}

}  // namespace shoal
