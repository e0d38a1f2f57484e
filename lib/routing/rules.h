// The broker's rules as data, under the names of the node-comms manual.
#pragma once

namespace shoal {

struct RoutingRules {
  double comms_range_m = 100;   ///< `comms_range`; negative: no limit, 0: nothing passes.
  double stale_time_s = 5;      ///< `stale_time`; negative: never stale.
  double stale_forget_s = 100;  ///< `stale_forget_s`; default 20 x stale_time; negative: never.

  bool operator==(const RoutingRules&) const = default;
};

}  // namespace shoal
