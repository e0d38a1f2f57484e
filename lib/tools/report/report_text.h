// A campaign's report for a terminal of 100 columns. docs/campaigns/report.md explains it.
#pragma once

#include <string>

#include "lib/tools/campaign/results.h"
#include "lib/tools/report/report_tables.h"

namespace shoal {

/// With more cases than this, those that matter are shown: with errors, timeouts or missing trials,
/// and with the lowest and highest values.
inline constexpr size_t kMaxCasesShown = 20;

/// Returns the report: outcomes of all and of each case, then a table of each metric. `all` shows
/// every case however many there are.
[[nodiscard]] std::string ReportText(const CampaignResults& results, const ReportTables& tables,
                                     bool all);

}  // namespace shoal
