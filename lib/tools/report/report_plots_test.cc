#include "lib/tools/report/report_plots.h"

#include <gtest/gtest.h>

#include <limits>

#include "lib/tools/campaign/campaign_testing.h"

namespace shoal {

namespace {

std::vector<Figure> FiguresOf(const CampaignResults& results) {
  return DrawReport(results, MakeReportTables(results), false);
}

bool Shows(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

CampaignResults Sweep(const std::vector<std::string>& values, int num_policies) {
  CampaignResults results = EmptyCampaign(5);
  results.sweep_keys = {"comms.comms_range"};
  for (const std::string& value : values) {
    for (int policy = 0; policy < num_policies; ++policy) {
      AddCase({value}, "P" + std::to_string(policy), &results);
      AddPasses(
          5, [&](int64_t i) { return i + 10 * policy; }, &results);
    }
  }
  return results;
}

}  // namespace

TEST(ReportPlots, DrawACurveOverTheFirstAxis) {
  const auto figures = FiguresOf(Sweep({"50", "100"}, 2));
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].name, "passed");
  EXPECT_EQ(figures[1].name, "metric_closest_m");
  EXPECT_TRUE(Shows(figures[1].data, "49.85 3 1.03")) << figures[1].data;
  EXPECT_TRUE(Shows(figures[1].data, "100.15 13 11.03")) << figures[1].data;
  EXPECT_TRUE(Shows(figures[1].script, "title 'policy=P1'")) << figures[1].script;
}

TEST(ReportPlots, MarkValuesThatAreNoNumbers) {
  const auto figures = FiguresOf(Sweep({"\"nolimit\"", "\"disk\""}, 1));
  EXPECT_TRUE(Shows(figures[0].script, "set xtics ('\"nolimit\"' 0, '\"disk\"' 1)"))
      << figures[0].script;
}

TEST(ReportPlots, DrawEightLinesAndNameTheRest) {
  const auto figures = FiguresOf(Sweep({"50", "100"}, 11));
  EXPECT_TRUE(Shows(figures[1].script, "(8 of 11 lines)"));
  EXPECT_TRUE(Shows(figures[1].script, "index 7 "));
  EXPECT_FALSE(Shows(figures[1].script, "index 8 "));
}

TEST(ReportPlots, DrawAHistogramWithoutASweep) {
  CampaignResults results = EmptyCampaign(100);
  AddCase({}, "", &results);
  AddPasses(
      100, [](int64_t i) { return i; }, &results);
  const auto figures = FiguresOf(results);
  EXPECT_TRUE(Shows(figures[1].data, "1 10\n")) << figures[1].data;
  EXPECT_TRUE(Shows(figures[1].script, "fillsteps")) << figures[1].script;
}

TEST(ReportPlots, LeaveOutWhatNoFigureCanShow) {
  CampaignResults results = EmptyCampaign(2);
  AddCase({}, "", &results);
  AddTrial(1, TrialOutcome::kPass, {std::numeric_limits<double>::infinity()}, &results);
  AddTrial(2, TrialOutcome::kPass, {TrialResult::kNoValue}, &results);
  const auto figures = FiguresOf(results);
  EXPECT_FALSE(figures[1].why_left_out.empty());
  EXPECT_TRUE(figures[0].why_left_out.empty());
}

}  // namespace shoal
