// A comparison of a campaign's cases for a terminal of 100 columns.
#pragma once

#include <string>

#include "lib/tools/report/compare.h"

namespace shoal {

/// Returns the pairs' outcomes at each point, then each metric's differences.
[[nodiscard]] std::string ComparisonText(const CampaignResults& results,
                                         const CampaignComparison& comparison);

}  // namespace shoal
