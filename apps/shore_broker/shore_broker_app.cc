#include "apps/shore_broker/shore_broker_app.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/shore_broker/air_text.h"
#include "apps/shore_broker/apply_control.h"
#include "apps/shore_broker/broker_page.h"
#include "apps/shore_broker/message_checks.h"
#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {

/// One step for the request, one for the answer; the rest allows for a slow launcher.
constexpr double kHold_s = 1;
Provenance ProvenanceAt(int64_t made_utime) {
  return {.origin = {}, .number = 0, .made_utime = made_utime};
}

/// True for a transmission that goes over media, as far as the rules let it.
bool IsInTransit(const std::vector<Decision>& decisions) {
  return std::any_of(decisions.begin(), decisions.end(),
                     [](const Decision& decision) { return decision.cause == Cause::kInTransit; });
}

/// Over ground; x East, y North, z down. Zero where NAV has no such number.
Eigen::Vector3d VelocityOf(const nav_t& nav) {
  const auto [east, north] = SinCos(DegToRad(nav.course_over_ground_deg));
  const Eigen::Vector3d velocity_mps(nav.speed_over_ground_mps * east,
                                     nav.speed_over_ground_mps * north, nav.descent_mps);
  return velocity_mps.allFinite() ? velocity_mps : Eigen::Vector3d::Zero();
}

}  // namespace

ShoreBrokerApp::ShoreBrokerApp(BrokerSetup setup, Bus& bus, BrokerShare share)
    : setup_(std::move(setup)),
      has_rays_(setup_.HasRays()),
      share_(std::move(share)),
      bus_(bus),
      inbox_(share_.has_rest ? BrokerInbox::Takes::kAll : BrokerInbox::Takes::kReports, bus, &log_),
      router_(setup_.rules, setup_.seed, setup_.vehicles),
      traffic_(setup_),
      delivery_(setup_, bus, &router_, &traffic_, &log_, share_.on_fates),
      intake_(inbox_, router_, traffic_, log_),
      reports_(setup_, share_, bus, {.router = router_, .media = traffic_, .delivery = delivery_}) {
  for (const auto& [name, factors] : setup_.factors) router_.SetFactors(name, factors);

  if (!setup_.rules.messages_over.is_direct()) {
    const std::vector<std::string> gateways = traffic_.Gateways();
    router_.SetGateways(gateways);
  }
  if (share_.has_rest && setup_.GoesByTruth()) {
    for (const std::string& name : setup_.vehicles) {
      Subscribe(bus, channels::Nav(name),
                [this, name](const nav_t& nav) { PlaceTruth(name, nav); });
    }
  }
  for (const ControlRow& row : ControlTable()) {
    Subscribe(bus, channels::Control(row), [this, &row](const unc_control_t& control) {
      controls_.push_back({.row = &row, .control = control});
    });
  }
  bus.SubscribeBytes(channels::UncControls().name,
                     [this](const Message& message) { KeepControls(message); });
}

void ShoreBrokerApp::PlaceTruth(const std::string& name, const nav_t& nav) {
  const Eigen::Vector3d position_m(nav.x_m, nav.y_m, nav.z_m);
  if (!position_m.allFinite()) return;
  traffic_.PlaceTruth(name, position_m, has_rays_ ? VelocityOf(nav) : Eigen::Vector3d::Zero());
  router_.PlaceTruth(name, position_m);
}

void ShoreBrokerApp::Tick(int64_t utime) {
  now_utime_ = utime;
  if (!began_) Begin(utime);
  HandOnCommands(utime);
  if (Holds(utime)) return;

  ApplyControls(utime);
  reports_.Route(utime, intake_.TakeAll(utime));
  for (const BrokerInbox::Item& message : inbox_.messages()) RouteMessage(utime, message);
  for (const BrokerInbox::Item& ack : inbox_.acks()) RouteAck(utime, ack);
  for (const BrokerInbox::Item& relay : inbox_.relays()) RouteRelay(utime, relay);
  for (const BrokerInbox::Item& packet : inbox_.packets()) {
    RoutePacket(utime, packet);
  }
  delivery_.TakeArrivals(utime);
  delivery_.Flush(utime);
  Forget(utime);
  inbox_.Clear();
}

void ShoreBrokerApp::Begin(int64_t utime) {
  began_ = true;
  start_utime_ = utime;
  rules_changed_ = true;
  holds_ = utime > setup_.start_utime;
  if (!holds_ || !share_.has_rest) return;
  unc_controls_req_t request;
  request.utime = utime;
  Publish(bus_, channels::UncControlsReq(), request);
  log_.Event(utime, "started during the mission: asks for the rules that were changed");
}

/// True while the rules are still asked for: until then what came in waits.
bool ShoreBrokerApp::Holds(int64_t utime) {
  if (!holds_) return false;
  if (!kept_controls_ && SecondsBetween(start_utime_, utime) < kHold_s) return true;
  holds_ = false;
  if (!kept_controls_) {
    log_.Warn(
        "no answer on UNC_CONTROLS which rules were changed before this broker started: the "
        "mission file's hold");
    return false;
  }
  std::vector<WaitingControl> kept;
  for (const kept_control_t& each : kept_controls_->controls) {
    const ControlRow* row = FindControlOnChannel(each.channel);
    if (row != nullptr) kept.push_back({.row = row, .control = each.control});
  }
  controls_.insert(controls_.begin(), kept.begin(), kept.end());
  return false;
}

/// Keeps the launcher's answer. An answer from an unregistered participant would replace it, so it
/// is ignored.
void ShoreBrokerApp::KeepControls(const Message& message) {
  if (message.publisher.empty()) {
    log_.Warn(
        "UNC_CONTROLS from outside the mission ignored: publish the controls themselves, UNC_*");
    return;
  }
  unc_controls_t controls;
  if (Decode(message.data, &controls)) {
    kept_controls_ = std::move(controls);
  } else {
    bus_.CountUndecodable(message.channel);
  }
}

void ShoreBrokerApp::ApplyControls(int64_t utime) {
  for (const WaitingControl& each : controls_) {
    if (ApplyControl(*each.row, each.control, utime, &router_, &log_)) rules_changed_ = true;
  }
  controls_.clear();
  if (!rules_changed_ || !share_.has_rest) return;
  rules_changed_ = false;
  BrokerRules rules = RulesNow(setup_, router_);
  rules.utime = utime;
  rules.is_start = !has_published_rules_;
  has_published_rules_ = true;
  Publish(bus_, channels::CommsRules(), ToMessage(rules));
}

void ShoreBrokerApp::HandOnCommands(int64_t utime) {
  for (const BrokerInbox::Item& item : inbox_.commands()) {
    helm_command_t command;
    if (!inbox_.Read(item, channels::HelmCommandAll(), &command)) continue;
    ++num_commands_handed_on_;
    log_.Event(utime, fmt::format("HELM_COMMAND handed on: {}", Printable(command.command)));
    for (const Contact* contact : router_.contacts()) {
      if (!contact->of_mission && !contact->known) continue;
      bus_.PublishBytes(channels::HelmCommand(contact->name).name, inbox_.BytesOf(item));
    }
  }
  inbox_.ClearCommands();
}

void ShoreBrokerApp::RouteMessage(int64_t utime, const BrokerInbox::Item& item) {
  if (!inbox_.Read(
          item,
          item.from_outside ? channels::NodeMessageFromOutside() : channels::NodeMessageLocal(),
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
                   .raw = inbox_.BytesOf(item),
                   .from_m = PositionOfSource(),
                   .has_pulses = true,
                   .color = color,
                   .air_bytes = [&] { return AirBytes(message_); },
                   .over = &setup_.rules.messages_over,
                   .provenance = ProvenanceAt(message_.utime)});
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

void ShoreBrokerApp::RouteAck(int64_t utime, const BrokerInbox::Item& item) {
  if (!inbox_.Read(item, channels::AckMessage(), &ack_)) return;
  const bool is_sound = !ack_.ack_id.empty();
  router_.RouteAck({.source = ack_.src_node, .destination = ack_.dest_node, .is_sound = is_sound},
                   utime, &decisions_, &unknown_names_);
  if (decisions_.front().cause == Cause::kInvalid) {
    log_.Warn("invalid ack refused: two vehicles' names and an ack_id are needed");
  }
  Conclude(utime, {.written_source = LegalOrEmpty(ack_.src_node),
                   .raw = inbox_.BytesOf(item),
                   .air_bytes = [&] { return AirBytes(ack_); },
                   .over = &setup_.rules.messages_over,
                   .provenance = ProvenanceAt(ack_.utime)});
}

void ShoreBrokerApp::RouteRelay(int64_t utime, const BrokerInbox::Item& item) {
  if (!inbox_.Read(item, channels::RelayTx(), &relay_)) return;
  const GatewayOptions* gateway = traffic_.GatewayAt(relay_.gateway);
  if (gateway == nullptr) {
    log_.Warn("RELAY_TX refused: only a gateway of the mission forwards");
    return;
  }
  std::optional<Kind> kind;
  for (const Kind each : {Kind::kReport, Kind::kMessage, Kind::kAck}) {
    if (relay_.kind == KindText(each)) kind = each;
  }
  if (kind && !relay_.refused.empty()) {
    for (const Cause cause : {Cause::kAlreadyReceived, Cause::kQueueFull, Cause::kHopLimit}) {
      if (relay_.refused != CauseText(cause)) continue;
      router_.RefuseForwarded(*kind, relay_.gateway, cause, &decisions_);
      return Conclude(utime, {.written_source = relay_.gateway});
    }
  }
  const MediaChoice over = {.names = relay_.media};
  if (!kind || over.names.empty() || !RouteRelayed(utime, over)) {
    log_.Warn(
        fmt::format("RELAY_TX of {} refused: it holds no report, message or ack with media "
                    "to forward it over",
                    relay_.gateway));
  }
}

bool ShoreBrokerApp::RouteRelayed(int64_t utime, const MediaChoice& over) {
  DecidedTransmission sent = {.written_source = relay_.gateway,
                              .raw = relay_.data,
                              .has_pulses = true,
                              .over = &over,
                              .provenance = {.origin = relay_.origin,
                                             .number = relay_.number,
                                             .made_utime = relay_.made_utime,
                                             .via = relay_.via}};
  if (relay_.kind == KindText(Kind::kReport)) {
    if (!Decode(relay_.data, &report_) || !AllNumbersAreFinite(report_)) return false;
    router_.RouteForwarded(relay_.gateway, report_.group, utime, &decisions_);
    sent.has_pulses = router_.rules().view_node_rpt_pulses;
    sent.color = ReportColor(std::max(decisions_.front().source, 0));
    sent.air_bytes = [&] {
      return AirBytes(report_, traffic().AddressOf(relay_.origin).value_or(0), setup_.start_utime);
    };
  } else if (relay_.kind == KindText(Kind::kMessage)) {
    if (!Decode(relay_.data, &message_)) return false;
    router_.RouteMessage({.source = message_.src_node,
                          .dest_node = message_.dest_node,
                          .dest_group = message_.dest_group,
                          .length_bytes = static_cast<int64_t>(message_.string_val.size()),
                          .is_sound = ProblemOf(message_).empty(),
                          .gateway = relay_.gateway},
                         utime, &decisions_, &unknown_names_);
    sent.color = router_.rules().msg_color;
    sent.air_bytes = [&] { return AirBytes(message_); };
  } else {
    if (!Decode(relay_.data, &ack_)) return false;
    router_.RouteAck({.source = ack_.src_node,
                      .destination = ack_.dest_node,
                      .is_sound = !ack_.ack_id.empty(),
                      .gateway = relay_.gateway},
                     utime, &decisions_, &unknown_names_);
    sent.has_pulses = false;
    sent.air_bytes = [&] { return AirBytes(ack_); };
  }
  sent.from_m = PositionOfSource();
  Conclude(utime, sent);
  return true;
}

void ShoreBrokerApp::RoutePacket(int64_t utime, const BrokerInbox::Item& item) {
  switch (item.packet) {
    case BrokerInbox::Packet::kAcousticTx:
      if (!inbox_.Read(item, channels::AcousticTx(), &packet_)) return;
      return RouteBytes(utime, item, packet_.source, packet_.payload, {});
    case BrokerInbox::Packet::kAcousticTxOn:
      if (!inbox_.Read(item, channels::AcousticTxOn(), &channel_packet_)) return;
      return RouteBytes(utime, item, channel_packet_.source, channel_packet_.payload,
                        {.channel = channel_packet_.channel});
    case BrokerInbox::Packet::kModemTx:
      break;
  }
  if (!inbox_.Read(item, channels::ModemTx(), &modem_packet_)) return;
  RouteBytes(utime, item, modem_packet_.source, modem_packet_.payload,
             {.data_rate_bps = modem_packet_.data_rate_bps});
}

/// `options.data_rate_bps`: present for what a modem sends; 0: at the network's. `options.channel`:
/// an id.
void ShoreBrokerApp::RouteBytes(int64_t utime, const BrokerInbox::Item& item,
                                const std::string& source, const std::vector<uint8_t>& payload,
                                const PacketOptions& options) {
  const std::optional<double> data_rate_bps = options.data_rate_bps;
  constexpr double kSlowest_bps = 0.1;
  constexpr double kFastest_bps = 1e9;
  const double rate_bps = data_rate_bps.value_or(0);
  const bool has_rate = rate_bps >= kSlowest_bps && rate_bps <= kFastest_bps;
  router_.RoutePacket({.source = source,
                       .length_bytes = static_cast<int64_t>(payload.size()),
                       .length_limit_bytes = traffic().max_payload_bytes(),
                       .is_sound = !payload.empty() && (has_rate || rate_bps == 0),
                       .has_range_rule = !data_rate_bps},
                      utime, &decisions_);
  if (decisions_.front().cause == Cause::kInvalid) {
    log_.Warn(data_rate_bps ? "invalid MODEM_TX refused: a vehicle's name, a payload and a data "
                              "rate of 0 or 0.1 to 1e9 bit/s are needed"
                            : "invalid ACOUSTIC_TX refused: a vehicle's name and a payload are "
                              "needed");
  }
  const MediaChoice& over = setup_.media.PacketsOver(source);
  if (options.channel && IsInTransit(decisions_)) {
    const std::string problem = traffic_.ChannelProblem(over, *options.channel);
    if (!problem.empty()) log_.Warn(fmt::format("ACOUSTIC_TX_ON of {}: {}", source, problem));
  }
  Conclude(utime, {.written_source = LegalOrEmpty(source),
                   .raw = inbox_.BytesOf(item),
                   .from_m = PositionOfSource(),
                   .has_pulses = true,
                   .color = router_.rules().msg_color,
                   .air_bytes = [&] { return payload; },
                   .data_rate_bps = has_rate ? std::optional(rate_bps) : std::nullopt,
                   .channel = options.channel,
                   .over = &over});
}

Eigen::Vector3d ShoreBrokerApp::PositionOfSource() const {
  const int32_t source = decisions_.front().source;
  if (source == kNoContact) return Eigen::Vector3d::Zero();
  return router_.contact(source).PositionFor(decisions_.front().kind);
}

void ShoreBrokerApp::Conclude(int64_t utime, DecidedTransmission sent) {
  sent.decisions = decisions_;
  sent.unknown_names = unknown_names_;
  delivery_.Conclude(utime, sent);
  decisions_.clear();
  unknown_names_.clear();
}

void ShoreBrokerApp::Forget(int64_t utime) {
  std::vector<int32_t> forgotten;
  router_.ForgetSilent(utime, &forgotten);
  for (const int32_t index : forgotten) {
    log_.Event(utime, fmt::format("{} is forgotten", router_.contact(index).name));
  }
}

std::vector<std::string> ShoreBrokerApp::RequestChannels() const {
  return {channels::CommsRulesReq().name};
}

std::optional<App::RequestAnswer> ShoreBrokerApp::Answer(std::string_view channel,
                                                         std::span<const uint8_t> data) const {
  comms_rules_req_t request;
  const bool is_request = channel == channels::CommsRulesReq().name && Decode(data, &request);
  if (!is_request || !has_published_rules_) return std::nullopt;
  BrokerRules rules = RulesNow(setup_, router_);
  rules.utime = now_utime_;
  RequestAnswer answer{.channel = channels::CommsRulesNow().name, .data = {}};
  EncodeInto(ToMessage(rules), &answer.data);
  return answer;
}

StatusPage ShoreBrokerApp::Status() const {
  StatusPage page;
  page.text = FormatBrokerPage(router_, traffic(),
                               {.start_utime = start_utime_,
                                .now_utime = now_utime_,
                                .num_commands_handed_on = num_commands_handed_on_,
                                .num_shared = reports_.shared().num_published(),
                                .num_undecodable = bus_.counters().undecodable});
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
