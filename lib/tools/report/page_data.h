// The data of a campaign's page.
#pragma once

#include <string>

#include "lib/tools/campaign/results.h"
#include "lib/tools/report/report_tables.h"

namespace shoal {

/// Returns JSON that may be in a <script> of HTML: it has no '<' and only ASCII. What is no
/// number, or infinite, is null. Of each case the numbers of its table and their texts as the text
/// report has them; of the trials a column for each value, with seven significant digits, in the
/// order of CampaignResults::rows. web/campaign/report_data.js reads it.
[[nodiscard]] std::string PageData(const CampaignResults& results, const ReportTables& tables,
                                   const std::string& dir);

}  // namespace shoal
