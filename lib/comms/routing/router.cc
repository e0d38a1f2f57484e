#include "lib/comms/routing/router.h"

#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/routing/decide.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

Router::Router(const RoutingRules& rules, uint64_t seed, std::span<const std::string> vehicles)
    : seed_(seed),
      contacts_(vehicles),
      broadcasts_(rules_, contacts_, ledger_),
      messages_(rules_, seed, contacts_, ledger_) {
  SetRules(rules);
}

void Router::SetRules(const RoutingRules& rules) {
  rules_ = rules;
  ignored_group_key_ = VehicleKey(rules.ignore_group);
  broadcasts_.OnRules();
}

std::optional<LinkFactors> Router::FindFactors(std::string_view name) const {
  if (!IsLegalVehicleName(name) || !contacts_.HasRoomFor(name)) return std::nullopt;
  const Contact* contact = contacts_.Find(name);
  return contact == nullptr ? LinkFactors() : contact->factors;
}

bool Router::SetFactors(std::string_view name, const LinkFactors& factors) {
  Contact* contact = IsLegalVehicleName(name) ? contacts_.FindOrAdd(name) : nullptr;
  if (contact == nullptr) return false;
  contact->factors = factors;
  broadcasts_.OnFactors();
  return true;
}

bool Router::RequestFullReports(std::string_view name) {
  Contact* receiver = contacts_.Find(name);
  if (receiver == nullptr || !(receiver->of_mission || receiver->known)) return false;
  contacts_.WantReports(receiver);
  return true;
}

Admission Router::Admit(const ReportFacts& report, int64_t utime) {
  if (!IsLegalVehicleName(report.name) || !report.position_m.allFinite()) {
    return Refuse(report.name);
  }
  std::string group_key = VehicleKey(report.group);
  if (!ignored_group_key_.empty() && group_key == ignored_group_key_) {
    return RefuseBecause(Cause::kIgnoredGroup, contacts_.Find(report.name));
  }
  Contact* contact = contacts_.FindOrAdd(report.name);
  if (contact == nullptr) return RefuseBecause(Cause::kTooManyVehicles, nullptr);

  contacts_.MarkKnown(contact);
  contact->group_key = group_key;
  contact->position_m = report.position_m;
  contact->received_utime = utime;
  ++contact->num_admitted;
  ++num_admitted_;
  broadcasts_.OnReport(*contact);
  return {.refused = std::nullopt,
          .source = contact->index,
          .number = ledger_.TakeNumber(Kind::kReport, contact),
          .position_m = report.position_m,
          .group_key = std::move(group_key)};
}

Admission Router::Refuse(std::string_view name) {
  return RefuseBecause(Cause::kInvalid, IsLegalVehicleName(name) ? contacts_.Find(name) : nullptr);
}

Admission Router::RefuseBecause(Cause cause, Contact* source) {
  ledger_.RecordRefusal(Kind::kReport, cause, source);
  return {.refused = cause,
          .source = source == nullptr ? kNoContact : source->index,
          .number = ledger_.TakeNumber(Kind::kReport, source),
          .position_m = Eigen::Vector3d::Zero(),
          .group_key = {}};
}

void Router::PlaceTruth(std::string_view name, const Eigen::Vector3d& position_m) {
  Contact* contact = contacts_.Find(name);
  if (contact == nullptr || !contact->of_mission) return;
  contact->true_position_m = position_m;
  broadcasts_.OnTruth();
}

void Router::Route(const Admission& report, int64_t utime, std::vector<Decision>* decisions) {
  SHOAL_CHECK(!report.refused, "the report was admitted");
  Contact* source = contacts_.at(report.source);
  Transmission sent = TransmissionOf(rules_, seed_, Kind::kReport, report.number, *source);
  sent.position_m = report.position_m;
  sent.group_key = report.group_key;
  broadcasts_.Route(sent, source, utime, decisions);
}

void Router::RouteForwarded(std::string_view gateway, std::string_view group, int64_t utime,
                            std::vector<Decision>* decisions) {
  Contact* source = contacts_.Find(gateway);
  if (source == nullptr || !source->known) {
    return RefuseForwarded(Kind::kReport, gateway, Cause::kUnknownSource, decisions);
  }
  Transmission sent = TransmissionOf(rules_, seed_, Kind::kReport,
                                     ledger_.TakeNumber(Kind::kReport, source), *source);
  const std::string group_key = VehicleKey(group);
  sent.group_key = group_key;
  sent.is_forwarded = true;
  if (num_known() > 1) return broadcasts_.Route(sent, source, utime, decisions);
  Decision decision;
  decision.number = sent.number;
  decision.cause = Cause::kNoDestination;
  ledger_.Record(rules_, decision, source, nullptr, decisions);
}

void Router::RefuseForwarded(Kind kind, std::string_view gateway, Cause cause,
                             std::vector<Decision>* decisions) {
  Contact* source = contacts_.Find(gateway);
  Decision decision;
  decision.kind = kind;
  decision.cause = cause;
  decision.number = ledger_.TakeNumber(kind, source);
  ledger_.Record(rules_, decision, source, nullptr, decisions);
}

void Router::RouteMessage(const MessageFacts& message, int64_t utime,
                          std::vector<Decision>* decisions,
                          std::vector<std::string>* unknown_names) {
  messages_.RouteMessage(message, utime, decisions, unknown_names);
}

void Router::RouteAck(const AckFacts& ack, int64_t utime, std::vector<Decision>* decisions,
                      std::vector<std::string>* unknown_names) {
  messages_.RouteAck(ack, utime, decisions, unknown_names);
}

void Router::RoutePacket(const PacketFacts& packet, int64_t utime,
                         std::vector<Decision>* decisions) {
  Contact* source = IsLegalVehicleName(packet.source) ? contacts_.Find(packet.source) : nullptr;
  const Contact no_contact;
  Transmission sent =
      TransmissionOf(rules_, seed_, Kind::kPacket, ledger_.TakeNumber(Kind::kPacket, source),
                     source == nullptr ? no_contact : *source);
  sent.has_range_rule = packet.has_range_rule;
  Decision decision = {
      .number = sent.number, .kind = Kind::kPacket, .cause = Cause::kNoDestination};
  if (!packet.is_sound || !IsLegalVehicleName(packet.source)) {
    decision.cause = Cause::kInvalid;
  } else if (source == nullptr || !source->TakesPart(Kind::kPacket)) {
    decision.cause = Cause::kUnknownSource;
  } else if (packet.length_bytes > packet.length_limit_bytes) {
    decision.cause = Cause::kTooLong;
    decision.length_bytes = packet.length_bytes;
    decision.length_limit_bytes = packet.length_limit_bytes;
  } else {
    const size_t num_before = decisions->size();
    broadcasts_.Route(sent, source, utime, decisions);
    if (decisions->size() > num_before) return;
  }
  ledger_.Record(rules_, decision, source, nullptr, decisions);
}

Decision Router::Conclude(const Decision& pending, std::string_view source,
                          std::string_view destination, Cause cause) {
  SHOAL_CHECK(pending.cause == Cause::kInTransit, "the decision is in transit");
  ledger_.Conclude(pending.kind, cause, contacts_.FindAt(pending.source, source),
                   contacts_.FindAt(pending.destination, destination));
  Decision concluded = pending;
  concluded.cause = cause;
  return concluded;
}

void Router::ForgetSilent(int64_t utime, std::vector<int32_t>* forgotten) {
  if (rules_.stale_forget_s < 0) return;
  for (Contact* contact : contacts_.all()) {
    if (!contact->known) continue;
    if (SecondsBetween(contact->received_utime, utime) < rules_.stale_forget_s) continue;
    contacts_.Forget(contact);
    broadcasts_.OnForgotten(*contact);
    if (forgotten != nullptr) forgotten->push_back(contact->index);
  }
}

int Router::NumStale(int64_t utime) const {
  int num_stale = 0;
  for (const Contact* contact : contacts_.all()) {
    if (contact->known && IsStale(rules_, contact->received_utime, utime)) ++num_stale;
  }
  return num_stale;
}

}  // namespace shoal
