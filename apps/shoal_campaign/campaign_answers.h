// `shoal campaign report` and `compare` of a folder, which is only read.
#pragma once

#include <optional>
#include <string>

#include "apps/shoal_campaign/campaign_report.h"

namespace shoal {

struct CampaignAnswerOptions {
  std::string dir;
  CampaignReportOptions report;
  bool has_page = false;  ///< `report --html`.
  std::string page_path;  ///< Empty: DIR/report.html.
};

/// Reads the folder and writes the report, figures and page. Returns the exit code.
int ReportCampaign(const CampaignAnswerOptions& options);

/// Reads the folder and writes the comparison. Returns the exit code.
int CompareCampaign(const std::string& dir, const CampaignCompareOptions& options);

}  // namespace shoal
