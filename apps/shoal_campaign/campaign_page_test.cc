#include "apps/shoal_campaign/campaign_page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "lib/base/check/result.h"
#include "lib/tools/campaign/campaign_testing.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

CampaignResults OneTrial() {
  CampaignResults results = EmptyCampaign(1);
  AddCase({}, "", &results);
  AddTrial(1, TrialOutcome::kPass, {7}, &results);
  return results;
}

}  // namespace

TEST(CampaignPage, NamesTheFolderByItsAbsolutePath) {
  const fs::path path =
      fs::path(::testing::TempDir()) / fmt::format("campaign_page_test_{}.html", getpid());
  std::ostringstream err;
  const CampaignResults results = OneTrial();
  EXPECT_EQ(
      WriteCampaignPage(results, MakeReportTables(results), "runs/./berta/", path.string(), err),
      kExitOk);
  EXPECT_EQ(err.str(), "");
  std::stringstream page;
  page << std::ifstream(path).rdbuf();
  const std::string dir = (fs::current_path() / "runs/berta").string();
  EXPECT_NE(page.str().find("\"dir\":\"" + dir + "\""), std::string::npos);
  fs::remove(path);
}

TEST(CampaignPage, StatesWhyItCannotBeWritten) {
  std::ostringstream err;
  const CampaignResults results = OneTrial();
  EXPECT_EQ(
      WriteCampaignPage(results, MakeReportTables(results), "/tmp", "/nonexistent/a.html", err),
      kExitEnvironment);
  EXPECT_NE(err.str().find("/nonexistent/a.html: No such file"), std::string::npos) << err.str();
  EXPECT_NE(err.str().find("--html FILE"), std::string::npos);
}

}  // namespace shoal
