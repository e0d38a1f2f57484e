#include "lib/routing/decide.h"

namespace shoal {

namespace {

/// A receiver whose position is old has no position to reckon with.
bool PassesStaleness(const RoutingRules& rules, const Contact& receiver, int64_t utime,
                     Decision* decision) {
  decision->age_s = SecondsBetween(receiver.received_utime, utime);
  if (rules.stale_time_s < 0) return true;
  decision->age_limit_s = rules.stale_time_s;
  return decision->age_s < decision->age_limit_s;
}

/// Strictly less, in three dimensions.
bool PassesRange(const RoutingRules& rules, const Transmission& sent, const Contact& receiver,
                 Decision* decision) {
  decision->range_m = (receiver.position_m - sent.position_m).norm();
  if (rules.comms_range_m < 0) return true;
  decision->limit_m = rules.comms_range_m * sent.stealth * receiver.factors.earange;
  return decision->range_m < decision->limit_m;
}

bool PassesDrop(const RoutingRules& rules, const Transmission& sent, const Contact& receiver,
                Decision* decision) {
  if (rules.drop_percentage <= 0 || !sent.link_key) return true;
  decision->loss_pct = rules.drop_percentage;
  Stream stream(sent.link_key->With(receiver.key).With(sent.number));
  return stream.Uniform() * 100 >= rules.drop_percentage;
}

bool PassesInterval(const RoutingRules& rules, int64_t delivered_utime, int64_t utime,
                    Decision* decision) {
  if (rules.min_rpt_interval_s < 0 || delivered_utime == kNever) return true;
  const double elapsed_s = SecondsBetween(delivered_utime, utime);
  if (elapsed_s >= rules.min_rpt_interval_s) return true;
  decision->wait_s = rules.min_rpt_interval_s - elapsed_s;
  return false;
}

/// True where the two are so close that each must know of the other.
bool IsCritical(const RoutingRules& rules, const Transmission& report, const Contact& receiver,
                Decision* decision) {
  if (rules.critical_range_m <= 0) return false;
  const double range_m = (receiver.position_m - report.position_m).norm();
  if (!(range_m < rules.critical_range_m)) return false;
  decision->range_m = range_m;
  decision->limit_m = rules.critical_range_m;
  return true;
}

}  // namespace

StreamKey DropKey(uint64_t seed, Kind kind, std::string_view source_key) {
  return StreamKey(seed, "drop_percentage").With(KindText(kind)).With(source_key);
}

Decision DecideReport(const RoutingRules& rules, const Transmission& report,
                      const Contact& receiver, int64_t delivered_utime, bool is_wanted,
                      int64_t utime) {
  Decision decision;
  if (is_wanted) {
    decision.override_rule = OverrideRule::kFullReport;
    decision.range_m = (receiver.position_m - report.position_m).norm();
    decision.age_s = SecondsBetween(receiver.received_utime, utime);
  } else if (!PassesStaleness(rules, receiver, utime, &decision)) {
    decision.cause = Cause::kStaleReceiver;
  } else if (IsCritical(rules, report, receiver, &decision)) {
    decision.override_rule = OverrideRule::kCriticalRange;
  } else if (!PassesRange(rules, report, receiver, &decision)) {
    decision.cause = Cause::kOutOfRange;
  } else if (rules.groups && report.group_key != receiver.group_key) {
    decision.cause = Cause::kOtherGroup;
  } else if (!PassesDrop(rules, report, receiver, &decision)) {
    decision.cause = Cause::kDropped;
  } else if (!PassesInterval(rules, delivered_utime, utime, &decision)) {
    decision.cause = Cause::kTooSoon;
  }
  return decision;
}

Decision DecideMessage(const RoutingRules& rules, const Transmission& message,
                       const Contact& receiver, int64_t utime) {
  Decision decision;
  if (rules.msg_groups && message.group_key != receiver.group_key) {
    decision.cause = Cause::kOtherGroup;
  } else if (!PassesStaleness(rules, receiver, utime, &decision)) {
    decision.cause = Cause::kStaleReceiver;
  } else if (!PassesRange(rules, message, receiver, &decision)) {
    decision.cause = Cause::kOutOfRange;
  } else if (!PassesDrop(rules, message, receiver, &decision)) {
    decision.cause = Cause::kDropped;
  }
  return decision;
}

Decision DecidePacket(const RoutingRules& rules, const Transmission& packet,
                      const Contact& receiver) {
  Decision decision;
  if (!PassesRange(rules, packet, receiver, &decision)) decision.cause = Cause::kOutOfRange;
  return decision;
}

bool IsStale(const RoutingRules& rules, int64_t received_utime, int64_t utime) {
  return rules.stale_time_s >= 0 && SecondsBetween(received_utime, utime) >= rules.stale_time_s;
}

}  // namespace shoal
