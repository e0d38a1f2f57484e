#include "apps/shoal_campaign/campaign_report.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <sstream>

#include "lib/base/check/result.h"
#include "lib/tools/campaign/campaign_testing.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

CampaignResults Whole() {
  CampaignResults results = EmptyCampaign(20);
  results.sweep_keys = {"comms.comms_range"};
  for (const char* range : {"50", "100"}) {
    for (const char* policy : {"A", "B"}) {
      AddCase({range}, policy, &results);
      AddPasses(
          20, [](int64_t i) { return i; }, &results);
    }
  }
  return results;
}

int ReportCode(const CampaignResults& results) {
  std::ostringstream out;
  std::ostringstream err;
  return RunCampaignReport({}, results, out, err);
}

}  // namespace

TEST(CampaignReport, ExitsWithOneWhereATrialBrokeOrIsMissing) {
  CampaignResults results = Whole();
  EXPECT_EQ(ReportCode(results), kExitOk);
  results.rows[3].result.outcome = TrialOutcome::kFail;
  EXPECT_EQ(ReportCode(results), kExitOk) << "a fail is an answer";
  results.rows[3].result.outcome = TrialOutcome::kTimeout;
  EXPECT_EQ(ReportCode(results), kExitMissionFailed);
  results.rows[3].result.outcome = TrialOutcome::kError;
  EXPECT_EQ(ReportCode(results), kExitMissionFailed);
  results = Whole();
  results.rows.erase(results.rows.begin() + 3);
  EXPECT_EQ(ReportCode(results), kExitMissionFailed);
}

TEST(CampaignReport, NamesTheRemedyWhereGnuplotIsMissing) {
  std::ostringstream out;
  std::ostringstream err;
  const CampaignReportOptions options = {
      .plots = true, .plots_dir = "/nowhere", .search_path = "/nonexistent"};
  EXPECT_EQ(RunCampaignReport(options, Whole(), out, err), kExitEnvironment);
  EXPECT_NE(err.str().find("gnuplot-nox"), std::string::npos);
  EXPECT_FALSE(out.str().empty()) << "the tables stand all the same";
}

TEST(CampaignReport, DrawsAFigureOfEachMetric) {
  const char* path = ::getenv("PATH");
  std::string folder = (fs::temp_directory_path() / "campaign-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const CampaignReportOptions options = {
      .plots = true, .plots_dir = folder + "/plots", .search_path = path == nullptr ? "" : path};
  std::ostringstream out;
  std::ostringstream err;
  const int code = RunCampaignReport(options, Whole(), out, err);
  if (err.str().find("gnuplot is missing") != std::string::npos) GTEST_SKIP() << "no gnuplot";
  EXPECT_EQ(code, kExitOk) << err.str();
  EXPECT_TRUE(fs::exists(folder + "/plots/passed.svg"));
  EXPECT_TRUE(fs::exists(folder + "/plots/metric_closest_m.svg"));
  EXPECT_FALSE(fs::exists(folder + "/plots/gnuplot"));
  fs::remove_all(folder);
}

TEST(CampaignCompare, ExitsWithTwoWhereNothingMatches) {
  std::ostringstream out;
  std::ostringstream err;
  EXPECT_EQ(RunCampaignCompare({.a = "policy=A", .b = "policy=C"}, Whole(), out, err), kExitUsage);
  EXPECT_NE(err.str().find("policy = A, B"), std::string::npos) << err.str();
  EXPECT_EQ(RunCampaignCompare({.a = "policy=A", .b = "policy=B"}, Whole(), out, err), kExitOk);
  EXPECT_NE(out.str().find("the same in every pair"), std::string::npos);
}

}  // namespace shoal
