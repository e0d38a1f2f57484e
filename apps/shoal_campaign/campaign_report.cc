#include "apps/shoal_campaign/campaign_report.h"

#include <fmt/format.h>

#include <ostream>

#include "lib/base/check/result.h"
#include "lib/tools/plot/drawing_folder.h"
#include "lib/tools/report/compare.h"
#include "lib/tools/report/compare_text.h"
#include "lib/tools/report/report_plots.h"
#include "lib/tools/report/report_tables.h"
#include "lib/tools/report/report_text.h"

namespace shoal {

int RunCampaignReport(const CampaignReportOptions& options, const CampaignResults& results,
                      std::ostream& out, std::ostream& err) {
  const ReportTables tables = MakeReportTables(results);
  out << ReportText(results, tables, options.all);
  if (options.plots) {
    const std::string gnuplot = FindGnuplot(options.search_path, err);
    if (gnuplot.empty()) return kExitEnvironment;
    const DrawingOptions drawing = {
        .out_dir = options.plots_dir, .png = options.png, .keep = options.keep};
    const int code = DrawInto(drawing, gnuplot, DrawReport(results, tables, options.png), out, err);
    if (code != kExitOk) return code;
  }
  return tables.IsFlawed() ? kExitMissionFailed : kExitOk;
}

int RunCampaignCompare(const CampaignCompareOptions& options, const CampaignResults& results,
                       std::ostream& out, std::ostream& err) {
  const Result<CampaignComparison> comparison = CompareCases(results, options.a, options.b);
  if (!comparison.ok()) {
    err << "shoal: " << comparison.error() << '\n';
    return kExitUsage;
  }
  out << ComparisonText(results, *comparison);
  return kExitOk;
}

}  // namespace shoal
