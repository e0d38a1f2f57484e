#include "lib/comms/routing/message_router.h"

#include <algorithm>

#include "lib/base/time/seconds.h"
#include "lib/comms/routing/decide.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {

Decision Refusal(Cause cause) {
  Decision decision;
  decision.cause = cause;
  return decision;
}

}  // namespace

void MessageRouter::SetGateways(std::span<const std::string> names) {
  gateways_.clear();
  for (const std::string& name : names) {
    if (Contact* contact = contacts_.Find(name)) gateways_.push_back(contact);
  }
  std::ranges::sort(gateways_, {}, &Contact::rank);
}

/// Gateways that a message is not for receive it too, but for the one that sends it and the vehicle
/// that made it.
void MessageRouter::AddGateways(const Contact& source, std::string_view maker, Audience* audience) {
  const std::string maker_key = VehicleKey(maker);
  for (Contact* gateway : gateways_) {
    const bool is_there =
        std::ranges::find(audience->contacts, gateway) != audience->contacts.end();
    if (!is_there && gateway->known && gateway != &source && gateway->key != maker_key) {
      audience->gateways.push_back(gateway);
    }
  }
}

void MessageRouter::RouteMessage(const MessageFacts& message, int64_t utime,
                                 std::vector<Decision>* decisions,
                                 std::vector<std::string>* unknown_names) {
  const Destinations named = ParseDestinations(message.dest_node);
  const bool is_addressed = named.all || !named.names.empty() || !message.dest_group.empty();
  const bool has_name = IsLegalVehicleName(message.source);
  const auto refuse_at_intake = [&](Cause cause, Contact* source) {
    Decision decision = Refusal(cause);
    decision.kind = Kind::kMessage;
    decision.number = ledger_.TakeNumber(Kind::kMessage, source);
    ledger_.Record(rules_, decision, source, nullptr, decisions);
  };
  if (!message.is_sound || !has_name || !is_addressed || named.too_many) {
    return refuse_at_intake(Cause::kInvalid, has_name ? contacts_.Find(message.source) : nullptr);
  }
  const bool is_forwarded = !message.gateway.empty();
  Contact* source = contacts_.FindOrAdd(is_forwarded ? message.gateway : message.source);
  if (source == nullptr) return refuse_at_intake(Cause::kTooManyVehicles, nullptr);

  if (!is_forwarded) source->last_message_utime = utime;
  Audience audience = Resolve(named, message.dest_group, *source);
  AddGateways(*source, message.source, &audience);
  Transmission sent = TransmissionOf(rules_, seed_, Kind::kMessage,
                                     ledger_.TakeNumber(Kind::kMessage, source), *source);
  if (const Contact* maker = is_forwarded ? contacts_.Find(message.source) : nullptr) {
    sent.group_key = maker->group_key;
  }
  const std::optional<Decision> refusal =
      RefuseMessage(message.length_bytes, is_forwarded, source, utime);
  const size_t begin = decisions->size();
  DecideAll(sent, refusal, audience, source, utime, decisions, unknown_names);
  for (size_t i = begin; i < decisions->size(); ++i) {
    Decision& decision = (*decisions)[i];
    if (decision.cause == Cause::kTooSoon) continue;  // The length was not asked yet.
    decision.length_bytes = message.length_bytes;
    if (rules_.max_msg_length_bytes > 0) decision.length_limit_bytes = rules_.max_msg_length_bytes;
  }
}

void MessageRouter::RouteAck(const AckFacts& ack, int64_t utime, std::vector<Decision>* decisions,
                             std::vector<std::string>* unknown_names) {
  const bool has_name = IsLegalVehicleName(ack.source);
  Contact* source =
      has_name ? contacts_.Find(ack.gateway.empty() ? ack.source : ack.gateway) : nullptr;
  const Contact no_contact;
  const Transmission sent =
      TransmissionOf(rules_, seed_, Kind::kAck, ledger_.TakeNumber(Kind::kAck, source),
                     source == nullptr ? no_contact : *source);

  const bool to_itself = VehicleKey(ack.source) == VehicleKey(ack.destination);
  if (!ack.is_sound || !has_name || to_itself || !IsLegalVehicleName(ack.destination)) {
    Decision decision = Refusal(Cause::kInvalid);
    decision.kind = Kind::kAck;
    decision.number = sent.number;
    return ledger_.Record(rules_, decision, source, nullptr, decisions);
  }
  Audience audience;
  if (Contact* receiver = contacts_.Find(ack.destination)) {
    audience.contacts.push_back(receiver);
  } else {
    audience.names.emplace_back(ack.destination);
  }
  if (source != nullptr) AddGateways(*source, ack.source, &audience);
  std::optional<Decision> refusal;
  if (source == nullptr || !source->known) refusal = Refusal(Cause::kUnknownSource);
  DecideAll(sent, refusal, audience, source, utime, decisions, unknown_names);
}

MessageRouter::Audience MessageRouter::Resolve(const Destinations& named,
                                               std::string_view dest_group, const Contact& source) {
  Audience audience;
  const std::string group_key = VehicleKey(dest_group);
  const bool to_all = named.all || group_key == "all";
  for (Contact* contact : contacts_.all()) {
    const bool is_meant = to_all || (!group_key.empty() && contact->group_key == group_key);
    if (contact->known && is_meant) audience.contacts.push_back(contact);
  }
  for (const std::string& name : named.names) {
    if (Contact* contact = contacts_.Find(name)) {
      audience.contacts.push_back(contact);
    } else {
      audience.names.push_back(name);
    }
  }
  std::erase(audience.contacts, &source);
  std::sort(audience.contacts.begin(), audience.contacts.end(),
            [](const Contact* a, const Contact* b) { return a->rank < b->rank; });
  audience.contacts.erase(std::unique(audience.contacts.begin(), audience.contacts.end()),
                          audience.contacts.end());
  return audience;
}

/// Returns what stops a message before its destinations are asked for.
std::optional<Decision> MessageRouter::RefuseMessage(int64_t length_bytes, bool is_forwarded,
                                                     Contact* source, int64_t utime) {
  if (!is_forwarded && source->message_utime != kNever) {
    const double elapsed_s = SecondsBetween(source->message_utime, utime);
    if (elapsed_s < rules_.min_msg_interval_s) {
      Decision decision = Refusal(Cause::kTooSoon);
      decision.wait_s = rules_.min_msg_interval_s - elapsed_s;
      return decision;
    }
  }
  if (!is_forwarded) source->message_utime = utime;
  if (rules_.max_msg_length_bytes > 0 && length_bytes > rules_.max_msg_length_bytes) {
    return Refusal(Cause::kTooLong);
  }
  if (!source->known) return Refusal(Cause::kUnknownSource);
  return std::nullopt;
}

void MessageRouter::DecideAll(const Transmission& message, const std::optional<Decision>& refusal,
                              const Audience& audience, Contact* source, int64_t utime,
                              std::vector<Decision>* decisions,
                              std::vector<std::string>* unknown_names) {
  const auto record = [&](Decision decision, Contact* receiver) {
    decision.kind = message.kind;
    decision.number = message.number;
    ledger_.Record(rules_, decision, source, receiver, decisions);
  };
  for (Contact* receiver : audience.contacts) {
    if (refusal) {
      record(*refusal, receiver);
    } else if (!receiver->known) {
      record(Refusal(Cause::kUnknownDestination), receiver);
    } else {
      record(DecideAt(message.kind,
                      {.rules = rules_, .sent = message, .receiver = *receiver, .utime = utime}),
             receiver);
    }
  }
  for (const std::string& name : audience.names) {
    Decision decision = refusal.value_or(Refusal(Cause::kUnknownDestination));
    decision.unknown_name = static_cast<int32_t>(unknown_names->size());
    unknown_names->push_back(name);
    record(decision, nullptr);
  }
  for (Contact* gateway : audience.gateways) {
    Decision decision = refusal.value_or(Decision());
    if (!refusal) {
      decision = DecideAt(message.kind,
                          {.rules = rules_, .sent = message, .receiver = *gateway, .utime = utime});
    }
    decision.is_overheard = true;
    record(decision, gateway);
  }
  if (audience.contacts.empty() && audience.names.empty() && audience.gateways.empty()) {
    record(refusal.value_or(Refusal(Cause::kNoDestination)), nullptr);
  }
}

}  // namespace shoal
