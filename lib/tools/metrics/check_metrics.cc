// Whether a mission has what metrics ask for.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "lib/mission/toml/table_place.h"
#include "lib/tools/metrics/metric_kinds.h"
#include "lib/tools/metrics/read_metrics.h"

namespace shoal {

namespace {

void CheckMetric(const Mission& mission, const TablePlace& place, MetricSpec* spec) {
  if (spec->from_s >= mission.duration_s) {
    place.Refuse("from_s", fmt::format("from_s = {} is not before the end of the mission, {} s: "
                                       "there is nothing left to measure",
                                       spec->from_s, mission.duration_s));
  }
  RowOf(spec->kind).check(mission, place, spec);
}

}  // namespace

void CheckMetrics(const Value& table, const Mission& mission, Problems& problems,
                  std::vector<MetricSpec>* metrics) {
  const TablePlace place(table, problems);
  for (MetricSpec& spec : *metrics) {
    const TablePlace own = place.Below(spec.name);
    if (own.IsSound()) CheckMetric(mission, own, &spec);
  }
}

}  // namespace shoal
