// `shoal campaign report --html`: the report as a page.
#pragma once

#include <iosfwd>
#include <string>

#include "lib/tools/campaign/results.h"
#include "lib/tools/report/report_tables.h"

namespace shoal {

/// Writes the page to `path`, in place of what bears that name. Its commands name the campaign's
/// folder `dir` by its absolute path, so that they work wherever they are pasted. Returns kExitOk,
/// or kExitEnvironment with the reason in `err`.
int WriteCampaignPage(const CampaignResults& results, const ReportTables& tables,
                      const std::string& dir, const std::string& path, std::ostream& err);

}  // namespace shoal
