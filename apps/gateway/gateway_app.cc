#include "apps/gateway/gateway_app.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "lib/comms/routing/cause.h"
#include "lib/comms/routing/destinations.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/sea/media/relay_path.h"

namespace shoal {

namespace {

constexpr std::string_view kVia = "via";

RelayLimits LimitsOf(const GatewayOptions& options) {
  return {.size = options.queue, .rate_hz = options.rate_hz, .max_hops = options.max_hops};
}

}  // namespace

GatewayApp::GatewayApp(const Mission& /*mission*/, const Vehicle& vehicle, Bus& bus)
    : name_(vehicle.name),
      options_(vehicle.media.gateway),
      bus_(bus),
      queue_(LimitsOf(vehicle.media.gateway)) {
  Subscribe(bus, channels::RelayRx(name_),
            [this](const relay_t& relay) { arrived_.push_back(relay); });
}

void GatewayApp::Tick(int64_t utime) {
  for (relay_t& relay : arrived_) TakeIn(utime, std::move(relay));
  arrived_.clear();
  while (std::optional<relay_t> relay = queue_.Take(utime)) {
    ++num_forwarded_;
    Publish(utime, std::move(*relay));
  }
}

void GatewayApp::TakeIn(int64_t utime, relay_t relay) {
  ++num_received_;
  if (!IsForOthers(relay)) {
    ++num_own_;
    return;
  }
  const RelayKey key = {relay.kind, VehicleKey(relay.origin), relay.number};
  const int num_hops = NumHops(relay.via);
  relay_t forwarded = relay;
  if (!MarkWay(&forwarded)) {
    bus_.CountUndecodable(channels::RelayRx(name_).name);
    log_.Warn(fmt::format("a {} that does not decode is not forwarded", Printable(relay.kind)));
    return;
  }
  switch (queue_.Offer(key, num_hops, std::move(forwarded))) {
    case RelayOffer::kWaits:
      return;
    case RelayOffer::kRepeated:
      return Refuse(utime, std::move(relay), Cause::kAlreadyReceived);
    case RelayOffer::kTooManyHops:
      return Refuse(utime, std::move(relay), Cause::kHopLimit);
    case RelayOffer::kFull:
      return Refuse(utime, std::move(relay), Cause::kQueueFull);
  }
}

void GatewayApp::Refuse(int64_t utime, relay_t relay, Cause cause) {
  ++num_refused_;
  relay.refused = CauseText(cause);
  Publish(utime, std::move(relay));
}

bool GatewayApp::MarkWay(relay_t* relay) {
  relay->via = WithHop(relay->via, name_);
  relay->media = options_.to;
  if (relay->kind == KindText(Kind::kReport)) {
    if (!Decode(relay->data, &report_)) return false;
    const auto extra = std::ranges::find(report_.extra, kVia, &key_value_t::key);
    if (extra == report_.extra.end()) {
      report_.extra.push_back({.key = std::string(kVia), .value = relay->via});
    } else {
      extra->value = relay->via;
    }
    report_.num_extra = static_cast<int32_t>(report_.extra.size());
    EncodeInto(report_, &relay->data);
  } else if (relay->kind == KindText(Kind::kMessage)) {
    if (!Decode(relay->data, &message_)) return false;
    const std::string mark = std::string(kVia) + "=";
    const size_t begin = message_.src_app.rfind(mark);
    message_.src_app.resize(std::min(begin, message_.src_app.size()));
    if (begin == std::string::npos && !message_.src_app.empty()) message_.src_app += ' ';
    message_.src_app += mark + relay->via;
    EncodeInto(message_, &relay->data);
  }
  relay->num_media = static_cast<int32_t>(relay->media.size());
  relay->num_bytes = static_cast<int32_t>(relay->data.size());
  return true;
}

/// False for a message that names nothing but this gateway.
bool GatewayApp::IsForOthers(const relay_t& relay) {
  if (relay.kind != KindText(Kind::kMessage) || !Decode(relay.data, &message_)) return true;
  const Destinations named = ParseDestinations(message_.dest_node);
  if (named.all || !message_.dest_group.empty()) return true;
  return std::ranges::any_of(named.names, [this](const std::string& name) {
    return VehicleKey(name) != VehicleKey(name_);
  });
}

void GatewayApp::Publish(int64_t utime, relay_t relay) {
  relay.utime = utime;
  shoal::Publish(bus_, tx_channel_, relay);
}

StatusPage GatewayApp::Status() const {
  StatusPage page;
  page.text = fmt::format(
      "Gateway:        {}\n"
      "From:           {}\n"
      "To:             {}\n"
      "Received:       {}\n"
      "    Forwarded:  {}\n"
      "    Waiting:    {} of {}\n"
      "    Refused:    {}\n"
      "    Its own:    {}\n",
      name_, fmt::join(options_.from, ", "), fmt::join(options_.to, ", "), num_received_,
      num_forwarded_, queue_.num_waiting(), options_.queue, num_refused_, num_own_);
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
