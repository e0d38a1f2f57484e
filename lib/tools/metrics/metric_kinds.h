// What there is to know about each kind of metric, in one row.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "lib/mission/model/mission.h"
#include "lib/mission/toml/fields.h"
#include "lib/mission/toml/table_place.h"
#include "lib/tools/metrics/metric.h"
#include "lib/tools/metrics/metric_watch.h"

namespace shoal {

struct MetricKindRow {
  MetricKind kind = MetricKind::kField;
  std::string_view word;  ///< Of campaign files.
  std::string_view unit;  ///< Of kField: the field's own.
  /// Reads its keys.
  void (*read)(Fields& fields, MetricSpec* spec);
  /// Refuses what the mission does not have, and writes vehicles as the mission does.
  void (*check)(const Mission& mission, const TablePlace& place, MetricSpec* spec);
  /// Returns what it is, in one line, without its time.
  std::string (*text)(const Mission& mission, const MetricSpec& spec);
  /// Returns what measures it; `now` outlives that.
  std::unique_ptr<MetricWatch> (*watch)(const Mission& mission, const MetricSpec& spec,
                                        const StepTime& now);
};

/// Returns all rows, in the order of MetricKind.
[[nodiscard]] std::span<const MetricKindRow> MetricKindTable();
[[nodiscard]] const MetricKindRow& RowOf(MetricKind kind);

/// Returns the unit of the metric's values, "m", "%", ""; of a field, by the end of its name.
[[nodiscard]] std::string UnitOfMetric(const MetricSpec& spec);
/// Returns what the metric is, in one line.
[[nodiscard]] std::string DescribeMetric(const Mission& mission, const MetricSpec& spec);

}  // namespace shoal
