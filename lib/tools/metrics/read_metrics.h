// The table [metrics] of a campaign file.
//
//   [metrics]
//   closest_m = { kind = "closest_approach", vehicle = "alpha", to = "all" }
//   depth = { channel = "NAV_ALPHA", field = "z_m", reduce = "max" }
#pragma once

#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/value.h"
#include "lib/tools/metrics/metric.h"

namespace shoal {

/// Reads all metrics of the table, in the order of their names, and notes everything that is wrong
/// with them by themselves. `table` is the value under "metrics".
void ReadMetrics(const Value& table, Problems& problems, std::vector<MetricSpec>* metrics);

/// Notes every vehicle, group, channel and field that `mission` does not have, and every metric
/// that has no meaning there; writes names of vehicles as the mission does. `table` is what
/// ReadMetrics made `metrics` of; those that it found unsound are left out.
void CheckMetrics(const Value& table, const Mission& mission, Problems& problems,
                  std::vector<MetricSpec>* metrics);

}  // namespace shoal
