#include "lib/comms/swarm/pending_report.h"

#include <algorithm>

#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/field_checks.h"

namespace shoal {

namespace {

constexpr int64_t kSentinelTime_us = -1'000'000;

}  // namespace

bool IsOutdated(const PendingReport& report, const SwarmContact& contact) {
  if (!contact.has_reported || !report.time_s || *report.time_s < 0) return false;
  return Microseconds(*report.time_s) < contact.reported_us;
}

void ApplyReport(const PendingReport& report, bool is_leader, int64_t now_us,
                 SwarmContact* contact) {
  const Eigen::Vector3d no_position_m = Eigen::Vector3d::Constant(contact->sentinel.position_m);
  const Eigen::Vector3d no_velocity_mps = Eigen::Vector3d::Constant(contact->sentinel.speed_mps);
  if (!contact->is_known) {
    contact->report = {.now = {no_position_m, no_velocity_mps},
                       .next = {no_position_m, no_velocity_mps}};
    contact->reported_us = kSentinelTime_us;
  }
  Motion& now = contact->report.now;
  now.position_m = report.position_m.value_or(now.position_m);
  now.velocity_mps = report.velocity_mps.value_or(now.velocity_mps);
  if (is_leader) {
    Motion& next = contact->report.next;
    next.position_m = report.next_position_m.value_or(next.position_m);
    next.velocity_mps = report.next_velocity_mps.value_or(next.velocity_mps);
  }
  if (report.time_s) {
    contact->reported_us =
        *report.time_s < 0 ? kSentinelTime_us : std::min(Microseconds(*report.time_s), now_us);
  }
  contact->arrived_us = now_us;
  contact->is_known = true;
  contact->has_reported = true;
  const bool is_whole = report.position_m && report.velocity_mps && report.time_s;
  if (is_whole && IsUsable(*contact)) {
    AppendToLog({.time_us = contact->reported_us, .motion = now}, &contact->log);
  }
}

}  // namespace shoal
