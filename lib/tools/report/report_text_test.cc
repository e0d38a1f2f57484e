#include "lib/tools/report/report_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "lib/tools/campaign/campaign_testing.h"
#include "lib/tools/report/table_text.h"

namespace shoal {

namespace {

std::string TextOf(const CampaignResults& results, bool all = false) {
  return ReportText(results, MakeReportTables(results), all);
}

bool HasPart(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// 500 cases of two trials; case 250 has a timeout.
CampaignResults ManyCases() {
  CampaignResults results = EmptyCampaign(2);
  results.sweep_keys = {"comms.comms_range"};
  for (int i = 0; i < 500; ++i) {
    AddCase({std::to_string(1000 + i)}, "", &results);
    AddTrial(1, TrialOutcome::kPass, {1.0 * i}, &results);
    AddTrial(2, i == 250 ? TrialOutcome::kTimeout : TrialOutcome::kPass, {2.0 * i}, &results);
  }
  return results;
}

}  // namespace

TEST(ReportText, StatesAllFourOutcomesAndTheBound) {
  CampaignResults results = EmptyCampaign(2995);
  AddCase({}, "", &results);
  AddPasses(
      2995, [](int64_t i) { return i; }, &results);
  const std::string text = TextOf(results);
  EXPECT_TRUE(HasPart(text,
                      "2,995 of 2,995 trials: 2,995 pass, 0 fail, 0 error, 0 timeout; 0 "
                      "missing"))
      << text;
  EXPECT_TRUE(HasPart(text, "0 of 2,995 did not pass: below 0.1 % at 95 %, one-sided")) << text;
}

TEST(ReportText, FitsAHundredColumns) {
  CampaignResults results = ManyCases();
  for (TrialRow& row : results.rows) {
    row.result.metrics = {-1.23456789e-300 * static_cast<double>(row.repetition)};
    row.result.why = std::string(300, 'w');
    if (row.case_number % 3 == 0) row.result.outcome = TrialOutcome::kFail;
  }
  std::istringstream lines(TextOf(results));
  for (std::string line; std::getline(lines, line);) {
    const auto width = std::count_if(line.begin(), line.end(), [](char letter) {
      return (static_cast<unsigned char>(letter) & 0xc0) != 0x80;
    });
    EXPECT_LE(width, 100) << line;
  }
}

TEST(ReportText, OfManyCasesShowsThoseThatMatter) {
  const CampaignResults results = ManyCases();
  const std::string text = TextOf(results);
  EXPECT_TRUE(HasPart(text, "\n1250 ")) << "it has a timeout";
  EXPECT_TRUE(HasPart(text, "\n1499 ")) << "it has the greatest mean";
  EXPECT_FALSE(HasPart(text, "\n1300 "));
  EXPECT_TRUE(HasPart(text, "480 cases not shown")) << text;
  EXPECT_TRUE(HasPart(text, "results.csv")) << text;
  EXPECT_TRUE(HasPart(TextOf(results, true), "\n1300 "));
}

TEST(ReportText, ShowsWhatIsNoNumberAsADash) {
  CampaignResults results = EmptyCampaign(2);
  AddCase({}, "", &results);
  AddTrial(1, TrialOutcome::kError, {}, &results);
  const std::string text = TextOf(results);
  EXPECT_FALSE(HasPart(text, "nan")) << text;
  EXPECT_TRUE(HasPart(text, "1 of 2 trials missing")) << text;
  EXPECT_TRUE(HasPart(text, "0000000000-1 error: why of 1")) << text;
}

TEST(TableText, OfNumbers) {
  EXPECT_EQ(DigitsText(std::numeric_limits<double>::quiet_NaN()), "-");
  EXPECT_EQ(DigitsText(1.7e308), "1.7e+308");
  EXPECT_EQ(IntervalText({1, 2.5}), "1 to 2.5");
  EXPECT_EQ(IntervalText({}), "-");
  EXPECT_EQ(IntervalText({.low = 3}), "from 3");
  EXPECT_EQ(CountText(-1234567), "-1,234,567");
  EXPECT_EQ(CountText(1, "trial"), "1 trial");
  EXPECT_EQ(PText(0.00001), "< 0.0001");
}

TEST(TableText, OfBoundsRoundsUp) {
  EXPECT_EQ(BoundText(0.00099974), "0.1 %");
  EXPECT_EQ(BoundText(0.01201), "1.3 %");
  EXPECT_EQ(BoundText(1), "100 %");
}

TEST(TableText, OfSharesDoesNotRoundToCertainty) {
  EXPECT_EQ(PercentText(1.0), "100.00 %");
  EXPECT_EQ(PercentText(0.5), "50.00 %");
  EXPECT_EQ(PercentText(0.000012), "0.0012 %");
  EXPECT_EQ(PercentText(0.99999), "99.9990 %");
  EXPECT_EQ(PercentText(Interval{0, 0.000999}), "0.00 to 0.100 %");
}

}  // namespace shoal
