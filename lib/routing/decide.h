// The rules of the node-comms manual, one after the other.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "lib/routing/contact.h"
#include "lib/routing/fate.h"
#include "lib/routing/rules.h"

namespace shoal {

/// Decides whether `receiver` hears a report that was sent at `source_m` (x East, y North, z down).
/// The first rule that stops it is the cause; the numbers of all rules that were asked come with
/// it. Rules in order: stale receiver, range. Source, destination and number are the caller's.
[[nodiscard]] Decision DecideReport(const RoutingRules& rules, const Eigen::Vector3d& source_m,
                                    const Contact& receiver, int64_t utime);

/// Returns true where a vehicle silent since `received_utime` is stale at `utime`.
[[nodiscard]] bool IsStale(const RoutingRules& rules, int64_t received_utime, int64_t utime);

}  // namespace shoal
