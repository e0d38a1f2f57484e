// The figures of a campaign's report, drawn by gnuplot.
#pragma once

#include <vector>

#include "lib/tools/campaign/results.h"
#include "lib/tools/plot/plot_script.h"
#include "lib/tools/report/report_tables.h"

namespace shoal {

/// Lines in one figure; of more cases, the first ones are drawn and the title names the rest.
inline constexpr size_t kMaxLines = 8;

/// Returns a figure of the share passed and one of each metric: with a sweep a curve over its first
/// axis with intervals, one line for each policy and each value of the other axes; without one,
/// the intervals of the policies and a histogram of each metric.
[[nodiscard]] std::vector<Figure> DrawReport(const CampaignResults& results,
                                             const ReportTables& tables, bool png);

}  // namespace shoal
