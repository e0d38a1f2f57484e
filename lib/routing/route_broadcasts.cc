// Router: what is for everybody, node reports and packets, from its source to each receiver.
#include <algorithm>

#include "lib/check/check.h"
#include "lib/routing/router.h"
#include "lib/routing/vehicle_name.h"

namespace shoal {

void Router::Route(const Admission& report, int64_t utime, std::vector<Decision>* decisions) {
  SHOAL_CHECK(!report.refused, "a refused report goes nowhere");
  Contact* source = by_index_[static_cast<size_t>(report.source)];
  Transmission sent = MakeTransmission(Kind::kReport, report.number, *source);
  sent.position_m = report.position_m;
  sent.group_key = report.group_key;
  Broadcast(sent, source, utime, decisions);
}

void Router::RoutePacket(const PacketFacts& packet, int64_t utime,
                         std::vector<Decision>* decisions) {
  Contact* source = IsLegalVehicleName(packet.source) ? Find(packet.source) : nullptr;
  const Contact nobody;
  const Transmission sent = MakeTransmission(Kind::kPacket, TakeNumber(Kind::kPacket, source),
                                             source == nullptr ? nobody : *source);
  Decision decision = {
      .number = sent.number, .kind = Kind::kPacket, .cause = Cause::kNoDestination};
  if (!packet.is_sound || !IsLegalVehicleName(packet.source)) {
    decision.cause = Cause::kInvalid;
  } else if (source == nullptr || !source->known) {
    decision.cause = Cause::kUnknownSource;
  } else if (packet.length_bytes > packet.length_limit_bytes) {
    decision.cause = Cause::kTooLong;
    decision.length_bytes = packet.length_bytes;
    decision.length_limit_bytes = packet.length_limit_bytes;
  } else if (num_known_ > 1) {
    return Broadcast(sent, source, utime, decisions);
  }
  Record(decision, source, nullptr, decisions);
}

void Router::Broadcast(const Transmission& sent, Contact* source, int64_t utime,
                       std::vector<Decision>* decisions) {
  if (CountsFarTogether()) return BroadcastNear(sent, source, utime, decisions);
  for (Contact* receiver : by_rank_) {
    if (receiver->known && receiver != source) {
      DecideAt(sent, source, receiver, utime, decisions);
    }
  }
}

void Router::DecideAt(const Transmission& sent, Contact* source, Contact* receiver, int64_t utime,
                      std::vector<Decision>* decisions) {
  if (sent.kind == Kind::kReport) {
    return DecideReportAt(sent, source, receiver, utime, decisions);
  }
  Decision decision = DecidePacket(rules_, sent, *receiver);
  decision.kind = sent.kind;
  decision.number = sent.number;
  Record(decision, source, receiver, decisions);
}

void Router::DecideReportAt(const Transmission& report, Contact* source, Contact* receiver,
                            int64_t utime, std::vector<Decision>* decisions) {
  const auto from = static_cast<size_t>(source->index);
  const auto to = static_cast<size_t>(receiver->index);
  const bool is_wanted = receiver->num_wanted > 0 && from < receiver->wants_report_of.size() &&
                         receiver->wants_report_of[from] != 0;
  if (to >= source->delivered_utime.size()) source->delivered_utime.resize(to + 1, kNever);
  int64_t& delivered_utime = source->delivered_utime[to];
  Decision decision = DecideReport(rules_, report, *receiver, delivered_utime, is_wanted, utime);
  decision.number = report.number;
  if (decision.cause == Cause::kDelivered) delivered_utime = utime;
  if (is_wanted) {
    receiver->wants_report_of[from] = 0;
    if (--receiver->num_wanted == 0) --num_wanting_;
  }
  Record(decision, source, receiver, decisions);
}

bool Router::CountsFarTogether() const {
  return num_known_ > rules_.each_fate_up_to && rules_.comms_range_m >= 0;
}

void Router::PrepareGrid() {
  if (grid_is_valid_) return;
  max_earange_ = 1;
  for (const Contact* contact : by_rank_) {
    max_earange_ = std::max(max_earange_, contact->factors.earange);
  }
  constexpr double kShortestSide_m = 1;
  grid_.Reset(
      std::max({rules_.comms_range_m * max_earange_, rules_.critical_range_m, kShortestSide_m}));
  for (const Contact* contact : by_rank_) {
    if (contact->known) grid_.Put(contact->index, contact->position_m);
  }
  grid_is_valid_ = true;
}

/// As for all receivers, but those out of reach are counted and not looked at.
void Router::BroadcastNear(const Transmission& sent, Contact* source, int64_t utime,
                           std::vector<Decision>* decisions) {
  PrepareGrid();
  const bool is_report = sent.kind == Kind::kReport;
  const double reach_m = std::max(rules_.comms_range_m * sent.stealth * max_earange_,
                                  is_report ? rules_.critical_range_m : 0);
  near_.clear();
  // A little more than the reach, against rounding in the squares' borders.
  grid_.AppendNear(sent.position_m, reach_m * (1 + 1e-9) + 1e-3, &near_);
  if (is_report && num_wanting_ > 0) {
    for (const Contact* contact : by_rank_) {
      if (contact->known && contact->num_wanted > 0) near_.push_back(contact->index);
    }
  }
  std::erase(near_, source->index);
  std::sort(near_.begin(), near_.end(),
            [this](int32_t a, int32_t b) { return contact(a).rank < contact(b).rank; });
  near_.erase(std::unique(near_.begin(), near_.end()), near_.end());

  int num_stale = is_report ? NumStale(utime) : 0;
  const auto counts_as_stale = [&](const Contact& contact) {
    return is_report && IsStale(rules_, contact.received_utime, utime);
  };
  if (counts_as_stale(*source)) --num_stale;
  for (const int32_t index : near_) {
    Contact* receiver = by_index_[static_cast<size_t>(index)];
    if (counts_as_stale(*receiver)) --num_stale;
    DecideAt(sent, source, receiver, utime, decisions);
  }
  const int num_others = num_known_ - 1 - static_cast<int>(near_.size());
  const auto record_others = [&](Cause cause, int count) {
    if (count == 0) return;
    Decision decision;
    decision.destination = kOthers;
    decision.count = count;
    decision.kind = sent.kind;
    decision.number = sent.number;
    decision.cause = cause;
    if (cause == Cause::kOutOfRange) decision.limit_m = reach_m;
    if (cause == Cause::kStaleReceiver) decision.age_limit_s = rules_.stale_time_s;
    Record(decision, source, nullptr, decisions);
  };
  record_others(Cause::kStaleReceiver, num_stale);
  record_others(Cause::kOutOfRange, num_others - num_stale);
}

}  // namespace shoal
