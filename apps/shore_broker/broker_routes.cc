// ShoreBrokerApp: what is heard, from the rules to its receivers, at once or through the water.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/shore_broker/air_text.h"
#include "apps/shore_broker/message_checks.h"
#include "apps/shore_broker/shore_broker_app.h"
#include "lib/check/check.h"
#include "lib/routing/vehicle_name.h"

namespace shoal {

namespace {

/// acoustic_path_t: without a modem there is no such number.
constexpr double kNoSnr_db = -999;

std::string LegalOrEmpty(const std::string& name) { return IsLegalVehicleName(name) ? name : ""; }

/// Returns where `vehicle` hears traffic of this kind.
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

acoustic_path_t PathOf(const Arrival& arrival, const AcousticTraffic& water) {
  const Reception& reception = arrival.reception;
  acoustic_path_t path;
  path.packet = reception.packet.number;
  path.channel = water.ChannelId(reception.channel);
  path.sent_utime = arrival.sent_utime;
  path.num_bytes = water.FrameBytes(arrival.shipment);
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
    path.colliders.push_back(water.NameOf(reception.colliders[static_cast<size_t>(i)]));
  }
  return path;
}

}  // namespace

void ShoreBrokerApp::RouteReport(int64_t utime, const WaitingReport& report) {
  router_.Route(report.admission, utime, &decisions_);
  const Contact& source = router_.contact(report.admission.source);
  Conclude(utime, {.written_source = source.name,
                   .raw = report.raw,
                   .from_m = report.admission.position_m,
                   .has_pulses = router_.rules().view_node_rpt_pulses,
                   .color = ReportColor(source.index),
                   .air_bytes = [&] {
                     SHOAL_CHECK(Decode(BytesOf(report.raw), &report_), "it did when it came");
                     return AirBytes(report_, water_.AddressOf(source.name).value_or(0),
                                     setup_.start_utime);
                   }});
  Share(utime, report);
}

void ShoreBrokerApp::RouteMessage(int64_t utime, const Waiting& waiting) {
  if (!DecodeWaiting(
          waiting,
          waiting.from_outside ? channels::NodeMessageFromOutside() : channels::NodeMessageLocal(),
          &message_)) {
    return;
  }
  const std::string_view problem = ProblemOf(message_);
  if (!problem.empty()) {
    log_.Warn(fmt::format("invalid node message refused: {}", problem));
  } else {
    log_.Event(
        utime,
        fmt::format("Msg rec'd: src_node={},dest_node={},dest_group={},var_name={},{}",
                    message_.src_node, Printable(message_.dest_node),
                    Printable(message_.dest_group), Printable(message_.var_name),
                    message_.is_double != 0 ? fmt::format("double_val={}", message_.double_val)
                                            : "string_val=" + Printable(message_.string_val)));
  }
  router_.RouteMessage({.source = message_.src_node,
                        .dest_node = message_.dest_node,
                        .dest_group = message_.dest_group,
                        .length_bytes = static_cast<int64_t>(message_.string_val.size()),
                        .is_sound = problem.empty()},
                       utime, &decisions_, &unknown_names_);
  const std::string color(problem.empty() ? MessageColor(message_) : "");
  Conclude(utime, {.written_source = LegalOrEmpty(message_.src_node),
                   .raw = waiting,
                   .from_m = PositionOfSource(),
                   .has_pulses = true,
                   .color = color,
                   .air_bytes = [&] { return AirBytes(message_); }});
}

/// A message whose ack_id has been here before is a repeat.
std::string_view ShoreBrokerApp::MessageColor(const node_message_t& message) {
  const RoutingRules& rules = router_.rules();
  if (!message.ack_id.empty() && repeats_.IsRepeat(VehicleKey(message.src_node), message.ack_id)) {
    return rules.msg_repeat_color;
  }
  constexpr size_t kLongestColor = 40;
  const bool has_own = !message.color.empty() && message.color.size() <= kLongestColor;
  return has_own ? std::string_view(message.color) : std::string_view(rules.msg_color);
}

void ShoreBrokerApp::RouteAck(int64_t utime, const Waiting& waiting) {
  if (!DecodeWaiting(waiting, channels::AckMessage(), &ack_)) return;
  const bool is_sound = !ack_.ack_id.empty();
  router_.RouteAck({.source = ack_.src_node, .destination = ack_.dest_node, .is_sound = is_sound},
                   utime, &decisions_, &unknown_names_);
  if (decisions_.front().cause == Cause::kInvalid) {
    log_.Warn("invalid ack refused: two vehicles' names and an ack_id are needed");
  }
  Conclude(utime, {.written_source = LegalOrEmpty(ack_.src_node), .raw = waiting, .air_bytes = [&] {
                     return AirBytes(ack_);
                   }});
}

void ShoreBrokerApp::RoutePacket(int64_t utime, const Waiting& waiting) {
  if (!DecodeWaiting(waiting, channels::AcousticTx(), &packet_)) return;
  router_.RoutePacket({.source = packet_.source,
                       .length_bytes = packet_.num_bytes,
                       .length_limit_bytes = water_.max_payload_bytes(),
                       .is_sound = packet_.num_bytes > 0},
                      utime, &decisions_);
  if (decisions_.front().cause == Cause::kInvalid) {
    log_.Warn("invalid ACOUSTIC_TX refused: a vehicle's name and a payload are needed");
  }
  Conclude(utime, {.written_source = LegalOrEmpty(packet_.source),
                   .raw = waiting,
                   .from_m = PositionOfSource(),
                   .has_pulses = true,
                   .color = router_.rules().msg_color,
                   .air_bytes = [&] { return packet_.payload; }});
}

Eigen::Vector3d ShoreBrokerApp::PositionOfSource() const {
  const int32_t source = decisions_.front().source;
  return source == kNobody ? Eigen::Vector3d::Zero() : router_.contact(source).position_m;
}

void ShoreBrokerApp::Conclude(int64_t utime, const Sent& sent) {
  // What is delivered goes out first: nobody waits for the telling of it.
  for (const Decision& decision : decisions_) {
    if (decision.cause != Cause::kDelivered) continue;
    const ReceiverChannels& receiver = ChannelsOf(decision.destination);
    bus_.PublishBytes(receiver.names[static_cast<size_t>(decision.kind)], BytesOf(sent.raw));
  }
  bool any_in_transit = false;
  for (const Decision& decision : decisions_) {
    if (decision.cause == Cause::kInTransit) {
      any_in_transit = true;
      continue;
    }
    const bool has_contact = decision.destination >= 0;
    const std::string_view source = decision.source == kNobody
                                        ? sent.written_source
                                        : std::string_view(router_.contact(decision.source).name);
    std::string written;
    if (decision.unknown_name >= 0) {
      written = Printable(unknown_names_[static_cast<size_t>(decision.unknown_name)]);
    }
    fates_.Add(utime, decision, source,
               has_contact ? std::string_view(router_.contact(decision.destination).name)
                           : std::string_view(written));
    if (decision.cause != Cause::kDelivered || !sent.has_pulses) continue;
    const Contact& receiver = router_.contact(decision.destination);
    pulses_.Add(utime,
                {.source = source,
                 .destination = receiver.name,
                 .from_m = sent.from_m,
                 .to_m = receiver.position_m,
                 .range_m = decision.range_m,
                 .of_message = decision.kind != Kind::kReport,
                 .color = sent.color},
                router_.rules().pulse_duration_s);
  }
  if (any_in_transit) SendThroughTheWater(utime, sent);
  decisions_.clear();
  unknown_names_.clear();
}

void ShoreBrokerApp::SendThroughTheWater(int64_t utime, const Sent& sent) {
  Shipment shipment;
  const std::span<const uint8_t> bytes = BytesOf(sent.raw);
  shipment.message.assign(bytes.begin(), bytes.end());
  shipment.payload = sent.air_bytes();
  shipment.has_pulses = sent.has_pulses;
  shipment.color = sent.color;
  for (const Decision& decision : decisions_) {
    if (decision.cause != Cause::kInTransit) continue;
    shipment.kind = decision.kind;
    shipment.number = decision.number;
    shipment.source = router_.contact(decision.source).name;
    shipment.legs.push_back(
        {.decision = decision, .destination = router_.contact(decision.destination).name});
  }
  const std::string source = shipment.source;
  for (const AcousticTraffic::Refusal& refusal : water_.Send(utime, std::move(shipment))) {
    const Decision concluded =
        router_.Conclude(refusal.leg.decision, source, refusal.leg.destination, refusal.cause);
    fates_.Add(utime, concluded, source, refusal.leg.destination);
  }
}

void ShoreBrokerApp::TakeArrival(int64_t utime, const Arrival& arrival) {
  const Shipment& shipment = arrival.shipment;
  const std::string& destination = arrival.leg.destination;
  Cause cause = arrival.cause;
  if (cause == Cause::kDamaged && !DeliverDamaged(utime, arrival)) {
    cause = Cause::kRejected;
  } else if (cause == Cause::kDelivered && shipment.kind == Kind::kPacket) {
    DeliverPacket(utime, arrival);
  } else if (cause == Cause::kDelivered) {
    bus_.PublishBytes(ChannelOf(shipment.kind, destination), shipment.message);
  }
  // The network handed over what a checksum, or the receiver, then threw away.
  const bool was_handed_over = HandsOver(arrival.reception.fate);
  const bool is_delivered = cause == Cause::kDelivered || cause == Cause::kDamaged;
  if (was_handed_over && !is_delivered) water_.CountRejection();

  const acoustic_path_t path = PathOf(arrival, water_);
  fates_.Add(utime, router_.Conclude(arrival.leg.decision, shipment.source, destination, cause),
             shipment.source, destination, &path);
  if (!is_delivered || !shipment.has_pulses) return;
  pulses_.Add(utime,
              {.source = shipment.source,
               .destination = destination,
               .from_m = shipment.from_m,
               .to_m = arrival.leg.to_m,
               .range_m = arrival.reception.range_m,
               .of_message = shipment.kind != Kind::kReport,
               .color = shipment.color},
              router_.rules().pulse_duration_s);
}

bool ShoreBrokerApp::DeliverDamaged(int64_t utime, const Arrival& arrival) {
  const Shipment& shipment = arrival.shipment;
  const std::string& destination = arrival.leg.destination;
  const auto publish = [&](const auto& channel, const auto& understood) {
    if (!understood) return false;
    Publish(bus_, channel, *understood);
    return true;
  };
  const auto decode = [&](auto* message) {
    SHOAL_CHECK(Decode(shipment.message, message), "it did when it came");
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
                                          return water_.VehicleAt(address);
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

void ShoreBrokerApp::DeliverPacket(int64_t utime, const Arrival& arrival) {
  acoustic_rx_t message;
  message.utime = utime;
  message.source = arrival.shipment.source;
  message.number = arrival.shipment.number;
  message.sent_utime = arrival.sent_utime;
  message.arrived_utime = water_.UtimeOf(arrival.reception.end_s);
  message.num_bytes = static_cast<int32_t>(arrival.payload.size());
  message.payload.assign(arrival.payload.begin(), arrival.payload.end());
  Publish(bus_, channels::AcousticRx(arrival.leg.destination), message);
}

const ShoreBrokerApp::ReceiverChannels& ShoreBrokerApp::ChannelsOf(int32_t index) {
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
