#include "apps/shore_broker/media_traffic.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/random/stream.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {

Cause CauseOf(RadioFault fault) {
  switch (fault) {
    case RadioFault::kSubmerged:
      return Cause::kSubmerged;
    case RadioFault::kBelowHorizon:
      return Cause::kBelowHorizon;
    case RadioFault::kWeakSignal:
      return Cause::kWeakSignal;
    case RadioFault::kOutOfRange:
    case RadioFault::kNone:
      break;
  }
  return Cause::kOutOfRange;
}

/// The network of [acoustics] has the mission's own seed.
uint64_t SeedOf(const BrokerSetup& setup, std::string_view medium) {
  if (medium == kAcousticMedium) return setup.seed;
  return StreamKey(setup.seed, "medium").With(medium).low();
}

bool HasMedium(const VehicleMedia& media, std::string_view medium) {
  return medium == kDirectMedium || std::ranges::find(media.names, medium) != media.names.end();
}

}  // namespace

MediaTraffic::MediaTraffic(const BrokerSetup& setup)
    : setup_(setup), has_media_(!setup.media.of_vehicles.empty()) {
  const auto add_acoustic = [&](const std::string& name, const Acoustics& acoustics) {
    std::vector<AcousticNode> nodes;
    for (size_t i = 0; i < setup.nodes.size(); ++i) {
      if (!has_media_ || HasMedium(setup.media.of_vehicles[i], name)) {
        nodes.push_back(setup.nodes[i]);
      }
    }
    media_.push_back({.name = name, .carrier = Carrier::kAcoustic, .acoustic = acoustics_.size()});
    acoustics_.push_back(
        std::make_unique<AcousticTraffic>(setup, acoustics, SeedOf(setup, name), nodes));
  };
  media_.push_back({.name = std::string(kDirectMedium)});
  add_acoustic(std::string(kAcousticMedium), setup.media.acoustics);
  for (const MediumOptions& medium : setup.media.media) {
    if (medium.kind == MediumKind::kAcoustic) {
      add_acoustic(medium.name, medium.acoustics);
    } else {
      media_.push_back({.name = medium.name,
                        .carrier = Carrier::kRadio,
                        .radio = medium.radio,
                        .terms = TermsOf(medium.radio)});
    }
  }
  for (const Medium& medium : media_) {
    unknown_node_.has.push_back(medium.carrier == Carrier::kRadio ? 0 : 1);
  }
  for (size_t i = 0; i < setup.media.of_vehicles.size(); ++i) {
    const VehicleMedia& media = setup.media.of_vehicles[i];
    Node& node = *FindOrAdd(setup.vehicles[i]);
    node.antenna_height_m = media.antenna_height_m;
    node.gateway = media.gateway;
    for (size_t k = 0; k < media_.size(); ++k) {
      node.has[k] = HasMedium(media, media_[k].name) ? 1 : 0;
    }
  }
}

MediaTraffic::Node* MediaTraffic::FindOrAdd(std::string_view name) {
  const std::string key = VehicleKey(name);
  const auto found = nodes_.find(key);
  if (found != nodes_.end()) return &found->second;
  if (nodes_.size() >= setup_.vehicles.size() + Router::kMaxUnregistered) return nullptr;
  const size_t number = nodes_.size();
  Node& node = nodes_[key];
  node.key = key;
  node.number = number;
  node.has.assign(media_.size(), 1);
  return &node;
}

const MediaTraffic::Node& MediaTraffic::NodeOf(std::string_view name) const {
  const auto found = nodes_.find(VehicleKey(name));
  return found == nodes_.end() ? unknown_node_ : found->second;
}

const MediaTraffic::Node& MediaTraffic::ReceiverOf(const ShipmentLeg& leg) {
  if (leg.decision.destination < 0) return NodeOf(leg.destination);
  const auto place = static_cast<size_t>(leg.decision.destination);
  if (place >= known_nodes_.size()) known_nodes_.resize(place + 1);
  KnownNode& known = known_nodes_[place];
  if (known.node == nullptr || known.name != leg.destination) {
    const Node& node = NodeOf(leg.destination);
    if (&node == &unknown_node_) return node;  // It may have room later.
    known = {.name = leg.destination, .node = &node};
  }
  return *known.node;
}

const RadioDraws& MediaTraffic::DrawsOf(size_t medium, Kind kind, Node* source,
                                        const Node& receiver) {
  const size_t row = medium * kNumKinds + static_cast<size_t>(kind);
  if (source->draws.size() <= row) source->draws.resize(row + 1);
  auto& draws = source->draws[row];
  if (draws.size() <= receiver.number) draws.resize(nodes_.size());
  std::optional<RadioDraws>& of_link = draws[receiver.number];
  if (!of_link) {
    of_link =
        RadioDrawsOf(setup_.seed, media_[medium].name, KindText(kind), source->key, receiver.key);
  }
  return *of_link;
}

void MediaTraffic::Place(std::string_view name, const Eigen::Vector3d& position_m) {
  Node* node = FindOrAdd(name);
  if (node != nullptr && !node->is_true)
    SetPosition(name, position_m, Eigen::Vector3d::Zero(), node);
}

void MediaTraffic::PlaceTruth(std::string_view name, const Eigen::Vector3d& position_m,
                              const Eigen::Vector3d& velocity_mps) {
  Node* node = position_m.allFinite() ? FindOrAdd(name) : nullptr;
  if (node == nullptr) return;
  node->is_true = true;
  SetPosition(name, position_m, velocity_mps, node);
}

void MediaTraffic::SetPosition(std::string_view name, const Eigen::Vector3d& position_m,
                               const Eigen::Vector3d& velocity_mps, Node* node) {
  node->position_m = position_m;
  for (size_t i = 0; i < media_.size(); ++i) {
    const Medium& medium = media_[i];
    if (medium.carrier != Carrier::kAcoustic || node->has[i] == 0) continue;
    acoustics_[medium.acoustic]->Place(name, position_m, velocity_mps);
  }
}

/// Returns the media of a choice, by their place in media_.
const std::vector<size_t>& MediaTraffic::Resolve(const MediaChoice& choice) {
  const std::string text = TextOf(choice);
  const auto found = resolved_.find(text);
  if (found != resolved_.end()) return found->second;
  std::vector<size_t>& places = resolved_[text];
  for (const std::string& name : choice.names) {
    for (size_t i = 0; i < media_.size(); ++i) {
      if (media_[i].name == name) places.push_back(i);
    }
  }
  return places;
}

MediaTraffic::Answer MediaTraffic::Ask(const Medium& medium, const Node& source,
                                       const Node& receiver) const {
  if (medium.carrier != Carrier::kRadio) return {};
  Answer answer;
  answer.radio = DecideRadio(
      medium.radio, medium.terms,
      {.position_m = source.position_m, .antenna_height_m = source.antenna_height_m},
      {.position_m = receiver.position_m, .antenna_height_m = receiver.antenna_height_m});
  if (answer.radio.fault != RadioFault::kNone) answer.cause = CauseOf(answer.radio.fault);
  return answer;
}

void MediaTraffic::Send(int64_t utime, Shipment shipment, const MediaChoice& choice,
                        const TakeLegEnd& take) {
  const std::vector<size_t>& candidates = Resolve(choice);
  const Node& source = NodeOf(shipment.source);
  // Taken for the time of this call: what is delivered at once may lead to another.
  std::vector<std::vector<ShipmentLeg>> legs_by_medium = std::move(legs_by_medium_);
  legs_by_medium.resize(media_.size());
  for (const size_t place : candidates) legs_by_medium[place].reserve(shipment.legs.size());
  std::vector<std::pair<ShipmentLeg, Cause>> stopped;
  for (ShipmentLeg& leg : shipment.legs) {
    const Node& receiver = ReceiverOf(leg);
    std::optional<Cause> cause;
    std::optional<LegMedium> faulty;
    std::shared_ptr<Copies> copies;
    int num_sent = 0;
    for (const size_t place : candidates) {
      const Medium& medium = media_[place];
      if (source.has[place] == 0 || receiver.has[place] == 0) continue;
      const Answer answer = Ask(medium, source, receiver);
      if (answer.cause) {
        if (cause) continue;
        cause = answer.cause;
        faulty.emplace(LegMedium{.name = medium.name, .radio = answer.radio});
        continue;
      }
      std::vector<ShipmentLeg>& legs = legs_by_medium[place];
      ShipmentLeg& copy =
          choice.at_once ? legs.emplace_back(leg) : legs.emplace_back(std::move(leg));
      copy.to_m = receiver.position_m;
      copy.medium.name = medium.name;
      copy.medium.radio = answer.radio;
      ++num_sent;
      if (!choice.at_once) break;
      if (copies == nullptr) copies = std::make_shared<Copies>();
      copy.copies = copies;
    }
    if (num_sent > 0) {
      if (copies != nullptr) copies->num_left = num_sent;
      num_surplus_ += num_sent - 1;
      continue;
    }
    // One that was moved has been sent. NOLINTNEXTLINE(bugprone-use-after-move)
    leg.medium = faulty.value_or(LegMedium());
    if (leg.medium.radio.range_m >= 0) {
      leg.decision.range_m = leg.medium.radio.range_m;
      leg.decision.limit_m = leg.medium.radio.limit_m;
    }
    stopped.emplace_back(std::move(leg), cause.value_or(Cause::kNoMedium));
  }
  shipment.legs.clear();
  if (has_media_) shipment.from_m = source.position_m;
  const auto shared = std::make_shared<const Shipment>(std::move(shipment));
  for (const auto& [leg, cause] : stopped) {
    End({.shipment = *shared, .leg = leg, .cause = cause, .sent_utime = utime}, take);
  }
  for (size_t place = 0; place < media_.size(); ++place) {
    if (legs_by_medium[place].empty()) continue;
    SendOver(place, utime, shared->source, shared, &legs_by_medium[place], take);
    legs_by_medium[place].clear();
  }
  legs_by_medium_ = std::move(legs_by_medium);
}

std::string MediaTraffic::ChannelProblem(const MediaChoice& choice, int id) {
  constexpr size_t kMaxShown = 10;
  std::string problem;
  for (const size_t place : Resolve(choice)) {
    if (media_[place].carrier != Carrier::kAcoustic) continue;
    const AcousticTraffic& acoustic = *acoustics_[media_[place].acoustic];
    if (acoustic.ChannelWith(id)) return "";
    std::string ids;
    const auto channels = acoustic.network().plan().channels();
    for (size_t i = 0; i < std::min(channels.size(), kMaxShown); ++i) {
      ids += fmt::format("{}{}", i == 0 ? "" : ", ", channels[i].id);
    }
    problem = fmt::format("{} has no channel {}: send on one of its channels, {}{}",
                          media_[place].name, id, ids, channels.size() > kMaxShown ? " ..." : "");
  }
  return problem;
}

void MediaTraffic::SendOver(size_t place, int64_t utime, std::string_view source,
                            const std::shared_ptr<const Shipment>& shipment,
                            std::vector<ShipmentLeg>* legs, const TakeLegEnd& take) {
  const Medium& medium = media_[place];
  switch (medium.carrier) {
    case Carrier::kDirect:
      for (ShipmentLeg& leg : *legs) {
        leg.medium.delay_s = 0;
        End({.shipment = *shipment,
             .leg = leg,
             .cause = Cause::kDelivered,
             .payload = shipment->payload,
             .sent_utime = utime,
             .arrived_utime = utime},
            take);
      }
      return;
    case Carrier::kAcoustic: {
      Shipment part = *shipment;
      part.legs = std::move(*legs);
      for (const AcousticTraffic::Refusal& refusal :
           acoustics_[medium.acoustic]->Send(utime, std::move(part))) {
        End({.shipment = *shipment,
             .leg = refusal.leg,
             .cause = refusal.cause,
             .sent_utime = utime},
            take);
      }
      return;
    }
    case Carrier::kRadio:
      break;
  }
  const int64_t published_utime = utime - setup_.tick_us;
  const int64_t sent_utime =
      delivered_utime_ ? std::max(published_utime, *delivered_utime_) : published_utime;
  Node* sender = FindOrAdd(source);
  SHOAL_CHECK(sender != nullptr, "what has a radio is a node");
  for (ShipmentLeg& leg : *legs) {
    const RadioDraws& draws = DrawsOf(place, shipment->kind, sender, ReceiverOf(leg));
    radio_.Send(shipment, std::move(leg), medium.radio, draws, sent_utime);
  }
}

void MediaTraffic::End(const LegEnd& end, const TakeLegEnd& take) {
  if (end.leg.copies == nullptr) return take(end);
  Copies& copies = *end.leg.copies;
  --copies.num_left;
  const bool decides = !copies.is_concluded && (IsReceived(end.cause) || copies.num_left == 0);
  if (!decides) {
    --num_surplus_;
    return;
  }
  copies.is_concluded = true;
  take(end);
}

void MediaTraffic::Deliver(int64_t utime, const TakeLegEnd& take) {
  const auto end = [&](const LegEnd& each) { End(each, take); };
  // What ends earlier is handed on earlier, whatever carries it.
  const auto take_acoustic = [&](const LegEnd& each) {
    radio_.Deliver(std::min(each.arrived_utime, utime), end);
    end(each);
  };
  if (acoustics_.size() > 1) {
    while (true) {
      AcousticTraffic* next = nullptr;
      int64_t next_utime = 0;
      for (const auto& acoustic : acoustics_) {
        const std::optional<int64_t> each = acoustic->NextUtime();
        if (!each || *each > utime || (next != nullptr && *each >= next_utime)) continue;
        next = acoustic.get();
        next_utime = *each;
      }
      // NextUtime is a microsecond early, and rounded.
      if (next == nullptr || next_utime + 2 > utime) break;
      next->Deliver(next_utime + 2, take_acoustic);
    }
  }
  for (const auto& acoustic : acoustics_) acoustic->Deliver(utime, take_acoustic);
  radio_.Deliver(utime, end);
  delivered_utime_ = delivered_utime_ ? std::max(utime, *delivered_utime_) : utime;
}

int64_t MediaTraffic::num_in_transit() const {
  int64_t num_legs = radio_.num_in_transit() - num_surplus_;
  for (const auto& acoustic : acoustics_) num_legs += acoustic->num_in_transit();
  return num_legs;
}

std::optional<int64_t> MediaTraffic::NextUtime() const {
  std::optional<int64_t> first = radio_.NextUtime();
  for (const auto& acoustic : acoustics_) {
    const std::optional<int64_t> each = acoustic->NextUtime();
    if (each && (!first || *each < *first)) first = each;
  }
  return first;
}

const GatewayOptions* MediaTraffic::GatewayAt(std::string_view name) const {
  const auto found = nodes_.find(VehicleKey(name));
  return found != nodes_.end() && found->second.gateway.exists ? &found->second.gateway : nullptr;
}

std::vector<std::string> MediaTraffic::Gateways() const {
  std::vector<std::string> names;
  for (size_t i = 0; i < setup_.media.of_vehicles.size(); ++i) {
    if (setup_.media.of_vehicles[i].gateway.exists) names.push_back(setup_.vehicles[i]);
  }
  return names;
}

}  // namespace shoal
