#include "lib/tools/trials/stop_values.h"

#include <vector>

namespace shoal {

std::optional<int64_t> StopValues::StopsAfter(const std::map<int64_t, double>& values,
                                              int64_t last) const {
  std::vector<double> in_order;
  for (const auto& [repetition, value] : values) {
    if (repetition > last || repetition != static_cast<int64_t>(in_order.size()) + 1) break;
    in_order.push_back(value);
  }
  return stopping_.StopsAfter(in_order);
}

std::optional<StopValues> StopValuesOf(const CampaignFolder& folder) {
  const auto& rule = folder.campaign.stop;
  if (!rule) return std::nullopt;
  size_t metric = 0;
  while (metric < folder.plan.metrics.size() && folder.plan.metrics[metric].name != rule->metric) {
    ++metric;
  }
  return StopValues(*rule, folder.campaign.repetitions, metric);
}

}  // namespace shoal
