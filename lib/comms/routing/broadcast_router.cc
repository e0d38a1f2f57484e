#include "lib/comms/routing/broadcast_router.h"

#include <algorithm>
#include <optional>

namespace shoal {

void BroadcastRouter::Route(const Transmission& sent, Contact* source, int64_t utime,
                            std::vector<Decision>* decisions) {
  const bool is_counted = contacts_.num_known() > rules_.each_fate_up_to;
  const bool goes_by_truth = sent.kind == Kind::kPacket && has_truth_;
  if (is_counted && !goes_by_truth && sent.has_range_rule && CountsFar(rules_, sent.kind)) {
    return RouteNear(sent, source, utime, decisions);
  }
  for (Contact* receiver : contacts_.all()) {
    if (receiver->TakesPart(sent.kind) && receiver != source) {
      DecideOne(sent, source, receiver, utime, decisions);
    }
  }
}

void BroadcastRouter::OnRules() {
  rules_without_range_ = rules_;
  rules_without_range_.comms_range_m = -1;
  grid_is_valid_ = false;
  ForgetStopped();
}

void BroadcastRouter::OnReport(const Contact& contact) {
  if (grid_is_valid_) grid_.Put(contact.index, contact.position_m);
  ForgetStopped();
}

void BroadcastRouter::OnForgotten(const Contact& contact) {
  if (grid_is_valid_) grid_.Remove(contact.index);
  ForgetStopped();
}

void BroadcastRouter::DecideOne(const Transmission& sent, Contact* source, Contact* receiver,
                                int64_t utime, std::vector<Decision>* decisions) {
  const RoutingRules& rules = sent.has_range_rule ? rules_ : rules_without_range_;
  LinkFacts link = {.rules = rules, .sent = sent, .receiver = *receiver, .utime = utime};
  const bool is_timed = sent.kind == Kind::kReport && !sent.is_forwarded;
  const auto to = static_cast<size_t>(receiver->index);
  if (is_timed) {
    link.delivered_utime = source->delivered_utime.Get(to);
    link.is_wanted = ContactBook::Wants(*receiver, *source);
  }
  Decision decision = DecideAt(sent.kind, link);
  decision.number = sent.number;
  if (is_timed && decision.cause == Cause::kDelivered) source->delivered_utime.At(to) = utime;
  if (link.is_wanted) contacts_.GiveWanted(receiver, *source);
  ledger_.Record(rules_, decision, source, receiver, decisions);
}

/// As for all receivers, but those out of reach are counted and not looked at.
void BroadcastRouter::RouteNear(const Transmission& sent, Contact* source, int64_t utime,
                                std::vector<Decision>* decisions) {
  PrepareGrid();
  const double reach_m = Reach_m(rules_, sent.kind, sent.stealth, max_earange_);
  FindNear(sent, *source, reach_m);
  CauseCounts stopped = CountStopped(sent.kind, utime);
  int64_t num_others = contacts_.num_known() - 1 - static_cast<int64_t>(near_.size());
  const auto leave_out = [&](const Contact& contact) {
    const std::optional<Cause> cause = CauseAt(rules_, sent.kind, contact, utime);
    if (cause) --stopped[static_cast<size_t>(*cause)];
  };
  leave_out(*source);
  for (const int32_t index : near_) {
    Contact* receiver = contacts_.at(index);
    leave_out(*receiver);
    DecideOne(sent, source, receiver, utime, decisions);
  }
  for (const int64_t count : stopped) num_others -= count;
  far_fates_.clear();
  AppendFarFates(rules_, sent.kind, reach_m, &far_fates_);
  for (Decision& fate : far_fates_) {
    // What no rule stops at the receiver is stopped by its range, the last of these.
    const bool is_last = &fate == &far_fates_.back();
    const int64_t count = is_last ? num_others : stopped[static_cast<size_t>(fate.cause)];
    if (count == 0) continue;
    fate.destination = kOthers;
    fate.count = static_cast<int32_t>(count);
    fate.number = sent.number;
    ledger_.Record(rules_, fate, source, nullptr, decisions);
  }
}

void BroadcastRouter::ForgetStopped() {
  for (StoppedCounts& stopped : stopped_) stopped.utime = kNever;
}

const CauseCounts& BroadcastRouter::CountStopped(Kind kind, int64_t utime) {
  StoppedCounts& stopped = stopped_[static_cast<size_t>(kind)];
  if (stopped.utime == utime) return stopped.counts;
  stopped = {.utime = utime, .counts = {}};
  for (const Contact* contact : contacts_.all()) {
    if (!contact->known) continue;
    const std::optional<Cause> cause = CauseAt(rules_, kind, *contact, utime);
    if (cause) ++stopped.counts[static_cast<size_t>(*cause)];
  }
  return stopped.counts;
}

/// Fills near_ with all that may be within reach, and with those that want this report, in order of
/// keys.
void BroadcastRouter::FindNear(const Transmission& sent, const Contact& source, double reach_m) {
  near_.clear();
  // A little more than the reach, against rounding in the squares' borders.
  grid_.AppendNear(sent.position_m, reach_m * (1 + 1e-9) + 1e-3, &near_);
  if (sent.kind == Kind::kReport && contacts_.num_wanting() > 0) {
    for (const Contact* contact : contacts_.all()) {
      if (contact->known && ContactBook::Wants(*contact, source)) {
        near_.push_back(contact->index);
      }
    }
  }
  std::erase(near_, source.index);
  std::sort(near_.begin(), near_.end(),
            [this](int32_t a, int32_t b) { return contacts_.at(a)->rank < contacts_.at(b)->rank; });
  near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
}

void BroadcastRouter::PrepareGrid() {
  if (grid_is_valid_) return;
  max_earange_ = 1;
  for (const Contact* contact : contacts_.all()) {
    max_earange_ = std::max(max_earange_, contact->factors.earange);
  }
  double side_m = 1;
  for (const Kind kind : {Kind::kReport, Kind::kPacket}) {
    side_m = std::max(side_m, Reach_m(rules_, kind, 1, max_earange_));
  }
  grid_.Reset(side_m);
  for (const Contact* contact : contacts_.all()) {
    if (contact->known) grid_.Put(contact->index, contact->position_m);
  }
  grid_is_valid_ = true;
}

}  // namespace shoal
