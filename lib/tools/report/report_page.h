// The report of a campaign as one page for a browser. docs/campaigns/report.md
#pragma once

#include <string>

#include "lib/tools/campaign/results.h"
#include "lib/tools/report/report_tables.h"

namespace shoal {

/// Returns the page as one HTML text, with all it needs: it asks no host for anything, and its
/// Content-Security-Policy forbids it. `dir` is the campaign's folder as the commands that replay
/// trials name it. Texts of the results are data: none of them is ever markup or script.
[[nodiscard]] std::string ReportPage(const CampaignResults& results, const ReportTables& tables,
                                     const std::string& dir);

}  // namespace shoal
