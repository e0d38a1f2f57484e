#include "lib/routing/decide.h"

namespace shoal {

namespace {

double SecondsBetween(int64_t earlier_utime, int64_t later_utime) {
  return static_cast<double>(later_utime - earlier_utime) / 1e6;
}

/// A receiver whose position is old has no position to reckon with.
bool PassesStaleness(const RoutingRules& rules, const Contact& receiver, int64_t utime,
                     Decision* decision) {
  decision->age_s = SecondsBetween(receiver.received_utime, utime);
  if (rules.stale_time_s < 0) return true;
  decision->age_limit_s = rules.stale_time_s;
  return decision->age_s < decision->age_limit_s;
}

/// Strictly less, in three dimensions.
bool PassesRange(const RoutingRules& rules, const Eigen::Vector3d& source_m,
                 const Contact& receiver, Decision* decision) {
  decision->range_m = (receiver.position_m - source_m).norm();
  if (rules.comms_range_m < 0) return true;
  decision->limit_m = rules.comms_range_m;
  return decision->range_m < decision->limit_m;
}

}  // namespace

Decision DecideReport(const RoutingRules& rules, const Eigen::Vector3d& source_m,
                      const Contact& receiver, int64_t utime) {
  Decision decision;
  if (!PassesStaleness(rules, receiver, utime, &decision)) {
    decision.cause = Cause::kStaleReceiver;
  } else if (!PassesRange(rules, source_m, receiver, &decision)) {
    decision.cause = Cause::kOutOfRange;
  }
  return decision;
}

bool IsStale(const RoutingRules& rules, int64_t received_utime, int64_t utime) {
  return rules.stale_time_s >= 0 && SecondsBetween(received_utime, utime) >= rules.stale_time_s;
}

}  // namespace shoal
