// For tests of the table [metrics] only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/mission/file/load.h"
#include "lib/mission/toml/parse.h"
#include "lib/tools/metrics/read_metrics.h"

namespace shoal {

/// A table [metrics] that was read, and what was found wrong with it.
struct MetricsOfText {
  std::vector<MetricSpec> metrics;
  std::vector<std::string> errors;
};

/// Reads `text`, the whole of a file whose table [metrics] begins in its first line; checks it
/// against `mission`, where there is one.
inline MetricsOfText ReadMetricsText(const std::string& text, const Mission* mission = nullptr) {
  Problems problems("c.toml", {});
  MetricsOfText result;
  const std::optional<Value> root = ParseToml(text, problems);
  const Value* table = root ? Find(std::get<Table>(root->data), "metrics") : nullptr;
  if (table != nullptr) {
    ReadMetrics(*table, problems, &result.metrics);
    if (mission != nullptr) CheckMetrics(*table, *mission, problems, &result.metrics);
  }
  result.errors = problems.InOrder();
  return result;
}

}  // namespace shoal
