#include "lib/tools/report/page_data.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lib/tools/campaign/campaign_testing.h"

namespace shoal {

namespace {

nlohmann::json DataOf(const CampaignResults& results) {
  return nlohmann::json::parse(PageData(results, MakeReportTables(results), "/tmp/berta"));
}

/// Two policies with trials of each outcome.
CampaignResults TwoPolicies() {
  CampaignResults results = EmptyCampaign(4);
  AddCase({}, "A", &results);
  AddPasses(
      3, [](int64_t i) { return static_cast<double>(i) / 3; }, &results);
  AddTrial(4, TrialOutcome::kFail, {1e300}, &results);
  AddCase({}, "B", &results);
  AddTrial(1, TrialOutcome::kError, {}, &results);
  AddTrial(3, TrialOutcome::kTimeout, {std::numeric_limits<double>::infinity()}, &results);
  return results;
}

}  // namespace

TEST(PageData, HasAColumnForEachValueOfTheTrials) {
  const auto trials = DataOf(TwoPolicies()).at("trials");
  EXPECT_EQ(trials.at("of_case").dump(), "[4,2]");
  EXPECT_EQ(trials.at("repetition").dump(), "[1,2,3,4,1,3]");
  EXPECT_EQ(trials.at("outcome"), "000123");
  EXPECT_EQ(trials.at("why").at("texts").dump(), R"(["","why of 4","why of 1","why of 3"])");
  EXPECT_EQ(trials.at("why").at("of").dump(), "[0,0,0,1,2,3]");
}

TEST(PageData, HasNullForWhatIsNoNumber) {
  const auto data = DataOf(TwoPolicies());
  EXPECT_EQ(data.at("trials").at("metrics").at(0).dump(),
            "[0.3333333,0.6666667,1.0,1e+300,null,null]");
  EXPECT_TRUE(data.at("cases").at(1).at("metrics").at(0).at("mean").at(1).is_null());
}

TEST(PageData, HasTheTextsOfTheTextReport) {
  CampaignResults results = EmptyCampaign(4);
  AddCase({"50"}, "", &results);
  AddPasses(
      4, [](int64_t i) { return i; }, &results);
  const ReportTables tables = MakeReportTables(results);
  const auto of_case = DataOf(results).at("cases").at(0);
  EXPECT_EQ(of_case.at("texts").at(5), "100.00 %");
  EXPECT_EQ(of_case.at("outcomes").dump(), "[4,0,0,0]");
  const auto metric = of_case.at("metrics").at(0);
  EXPECT_EQ(metric.at("texts").size(), 12U);
  EXPECT_EQ(metric.at("texts").at(2), "2.5");
  const auto data = DataOf(results);
  EXPECT_EQ(data.at("outcome_columns").size(), of_case.at("texts").size());
  EXPECT_EQ(data.at("outcome_columns").at(5), "passed");
  EXPECT_EQ(data.at("metric_columns").size(), metric.at("texts").size());
  EXPECT_EQ(data.at("metric_columns").at(2), "mean");
  EXPECT_EQ(metric.at("mean").at(1).get<double>(), tables.cases[0].metrics[0].mean.interval.low);
}

TEST(PageData, NumbersOutcomesAsThePageNamesThem) {
  std::string names;
  for (const std::string_view name : kTrialOutcomeNames) {
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", name);
  }
  std::stringstream script;
  script << std::ifstream(SHOAL_SOURCE_DIR "/web/campaign/report_data.js").rdbuf();
  EXPECT_NE(script.str().find("kOutcomes = [" + names + "]"), std::string::npos) << names;
}

TEST(PageData, PutsKeysThatVaryTogetherOnOneAxis) {
  CampaignResults results = EmptyCampaign(1);
  results.sweep_keys = {"a", "b", "c"};
  results.campaign.sweep = {{.keys = {"a", "c"}, .values = {}}};
  EXPECT_EQ(DataOf(results).at("axes").dump(), "[[0,2],[1]]");
}

TEST(PageData, HasSamplesAsNumbersWhereAllAreSome) {
  CampaignResults results = TwoPolicies();
  results.sampled_keys = {"x", "name"};
  for (TrialRow& row : results.rows) {
    row.samples = {"0.123456789", row.repetition == 1 ? "\"one\"" : "2"};
  }
  const auto samples = DataOf(results).at("trials").at("samples");
  EXPECT_EQ(samples.at(0).at("numbers").at(5), 0.1234568);
  EXPECT_EQ(samples.at(1).at("of").dump(), "[0,1,1,1,0,1]");
}

TEST(PageData, CannotLeaveItsScript) {
  CampaignResults results = TwoPolicies();
  results.metrics[0].name = "</script><script>alert(1)</script>";
  results.rows[3].result.why = "<!-- \xff\xfe \xe2\x80\xa8 ]]>";
  const std::string text = PageData(results, MakeReportTables(results), "</SCRIPT>");
  EXPECT_EQ(text.find('<'), text.npos);
  for (const char letter : text) EXPECT_GE(letter, ' ') << "ASCII only";
  const auto data = nlohmann::json::parse(text);
  EXPECT_EQ(data.at("metrics").at(0).at("name"), results.metrics[0].name);
  EXPECT_EQ(data.at("dir"), "</SCRIPT>");
}

}  // namespace shoal
