// `shoal campaign report` and `shoal campaign compare`: what a campaign's results show.
#pragma once

#include <iosfwd>
#include <string>

#include "lib/tools/campaign/results.h"

namespace shoal {

struct CampaignReportOptions {
  bool all = false;         ///< Shows every case however many there are.
  bool plots = false;       ///< Draws figures too.
  std::string plots_dir;    ///< Made where it does not exist. @pre not empty with `plots`
  bool png = false;         ///< Figures are PNG instead of SVG.
  bool keep = false;        ///< Leaves gnuplot's data and scripts in <plots_dir>/gnuplot.
  std::string search_path;  ///< Where gnuplot is looked for: PATH.
};

/// Writes the report to `out` and draws the figures; errors go to `err`. Returns kExitOk,
/// kExitMissionFailed where a trial is an error or a timeout, or is missing, and kExitEnvironment
/// where the figures cannot be drawn.
int RunCampaignReport(const CampaignReportOptions& options, const CampaignResults& results,
                      std::ostream& out, std::ostream& err);

struct CampaignCompareOptions {
  std::string a;  ///< KEY=VALUE, several with commas between.
  std::string b;
};

/// Writes the comparison to `out`. Returns kExitOk, or kExitUsage with the error in `err` where a
/// selection matches nothing.
int RunCampaignCompare(const CampaignCompareOptions& options, const CampaignResults& results,
                       std::ostream& out, std::ostream& err);

}  // namespace shoal
