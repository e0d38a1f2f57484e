// What a metric is, for people.
#pragma once

#include <string>

#include "lib/mission/model/mission.h"
#include "lib/tools/metrics/metric.h"

namespace shoal {

/// Returns "m", "s", "%", "J"; of a field what the end of its name states ("_mps": "m/s"), empty
/// where that is no unit.
[[nodiscard]] std::string UnitOfMetric(const MetricSpec& spec);

/// Returns one line: "least range from alpha to every vehicle".
[[nodiscard]] std::string DescribeMetric(const Mission& mission, const MetricSpec& spec);

}  // namespace shoal
