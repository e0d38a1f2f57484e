#include "apps/shoal_campaign/campaign_answers.h"

#include <fmt/format.h>

#include <iostream>

#include "apps/shoal_campaign/campaign_page.h"
#include "apps/shoal_campaign/campaign_setup.h"
#include "lib/tools/report/report_tables.h"
#include "lib/tools/trials/campaign_folder.h"
#include "lib/tools/trials/reduce.h"

namespace shoal {

namespace {

/// Reads the results of a folder, or prints why not and returns an exit code.
std::optional<int> ReadAnswers(const std::string& dir, CampaignResults* results) {
  const Result<CampaignFolder> folder = ReadCampaignFolder(dir);
  if (!folder.ok()) {
    ShowError("shoal: {}\n", folder.error());
    return kExitUsage;
  }
  Result<CampaignResults> read = ReadResults(*folder);
  if (!read.ok()) {
    ShowError("shoal: {}\n", read.error());
    return kExitEnvironment;
  }
  *results = *std::move(read);
  return std::nullopt;
}

}  // namespace

int ReportCampaign(const CampaignAnswerOptions& options) {
  CampaignResults results;
  if (const auto code = ReadAnswers(options.dir, &results)) return *code;
  const int code = RunCampaignReport(options.report, results, std::cout, std::cerr);
  if (!options.has_page || code == kExitEnvironment) return code;
  const std::string path =
      options.page_path.empty() ? options.dir + "/report.html" : options.page_path;
  const int page_code =
      WriteCampaignPage(results, MakeReportTables(results), options.dir, path, std::cerr);
  if (page_code != kExitOk) return page_code;
  std::cout << path << '\n';
  return code;
}

int CompareCampaign(const std::string& dir, const CampaignCompareOptions& options) {
  CampaignResults results;
  if (const auto code = ReadAnswers(dir, &results)) return *code;
  return RunCampaignCompare(options, results, std::cout, std::cerr);
}

}  // namespace shoal
