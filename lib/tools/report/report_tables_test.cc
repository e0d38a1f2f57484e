#include "lib/tools/report/report_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/base/statistics/share_interval.h"
#include "lib/tools/campaign/campaign_testing.h"

namespace shoal {

namespace {

constexpr double kNone = TrialResult::kNoValue;

/// One case with each of the outcomes: 6 pass, 2 fail, 1 error, 1 timeout.
CampaignResults EachOutcome() {
  CampaignResults results = EmptyCampaign(10);
  AddCase({}, "", &results);
  AddPasses(
      6, [](int64_t i) { return 10 * i; }, &results);
  AddTrial(7, TrialOutcome::kFail, {35}, &results);
  AddTrial(8, TrialOutcome::kError, {}, &results);
  AddTrial(9, TrialOutcome::kTimeout, {kNone}, &results);
  AddTrial(10, TrialOutcome::kFail, {3}, &results);
  return results;
}

}  // namespace

TEST(ReportTables, HaveAllFourOutcomesInTheDenominator) {
  const ReportTables tables = MakeReportTables(EachOutcome());
  const CaseTable& table = tables.cases.at(0);
  EXPECT_EQ(table.outcomes.of, (std::array<int64_t, 4>{6, 2, 1, 1}));
  EXPECT_DOUBLE_EQ(table.share_passed.value, 0.6);
  EXPECT_EQ(table.share_passed.interval, ShareInterval(6, 10, 0.95));
  EXPECT_EQ(table.num_missing, 0);
  EXPECT_TRUE(tables.IsFlawed()) << "an error and a timeout";
}

TEST(ReportTables, CountTrialsWithoutAValueApart) {
  const ReportTables tables = MakeReportTables(EachOutcome());
  const MetricSummary& metric = tables.cases.at(0).metrics.at(0);
  EXPECT_EQ(metric.num, 8);
  EXPECT_EQ(metric.num_without, 2);
  EXPECT_DOUBLE_EQ(metric.mean.value, 248 / 8.0);
  EXPECT_EQ(metric.min, 3);
  EXPECT_EQ(metric.max, 60);
  EXPECT_DOUBLE_EQ(metric.quantiles[1].value, 32.5);
}

TEST(ReportTables, NoteFailsFirstThenWhatIsFarFromTheMedian) {
  const ReportTables tables = MakeReportTables(EachOutcome());
  const auto& worst = tables.cases.at(0).metrics.at(0).worst;
  ASSERT_EQ(worst.size(), kMaxNoted);
  EXPECT_EQ(worst[0].key, (TrialKey{"0000000000", 10}));
  EXPECT_EQ(worst[1].key, (TrialKey{"0000000000", 7}));
  EXPECT_EQ(worst[2].key.repetition, 6) << "60 is farther from 32.5 than 10 is";
  EXPECT_EQ(worst[3].key.repetition, 1);
}

TEST(ReportTables, NoteErrorsAndTimeoutsBeforeFails) {
  const ReportTables tables = MakeReportTables(EachOutcome());
  const auto& noted = tables.cases.at(0).not_passed;
  ASSERT_EQ(noted.size(), 4U);
  EXPECT_EQ(noted[0].outcome, TrialOutcome::kError);
  EXPECT_EQ(noted[1].outcome, TrialOutcome::kTimeout);
  EXPECT_EQ(noted[2].key.repetition, 7);
  EXPECT_EQ(noted[2].why, "why of 7");
}

TEST(ReportTables, CountWhatIsMissing) {
  CampaignResults results = EmptyCampaign(10);
  AddCase({}, "A", &results);
  AddPasses(
      10, [](int64_t) { return 1; }, &results);
  AddCase({}, "B", &results);
  AddTrial(2, TrialOutcome::kPass, {1}, &results);
  AddCase({}, "C", &results);
  const ReportTables tables = MakeReportTables(results);
  EXPECT_EQ(tables.num_missing, 9 + 10);
  EXPECT_EQ(tables.num_expected, 30);
  EXPECT_EQ(tables.cases[1].num_missing, 9);
  EXPECT_EQ(tables.cases[2].outcomes.num(), 0);
  EXPECT_TRUE(std::isnan(tables.cases[2].share_passed.value));
  EXPECT_EQ(tables.cases[2].share_passed.interval, (Interval{0, 1}));
  EXPECT_TRUE(std::isnan(tables.cases[2].metrics[0].mean.value));
  EXPECT_TRUE(tables.IsFlawed());
}

TEST(ReportTables, BoundWhatWasNeverSeen) {
  CampaignResults results = EmptyCampaign(2995);
  AddCase({}, "", &results);
  AddPasses(
      2995, [](int64_t) { return 1; }, &results);
  const ReportTables tables = MakeReportTables(results);
  ASSERT_TRUE(tables.cases[0].bound_of_none.has_value());
  EXPECT_LT(*tables.cases[0].bound_of_none, 1e-3);
  EXPECT_FALSE(tables.IsFlawed());
  EXPECT_FALSE(MakeReportTables(EachOutcome()).cases[0].bound_of_none.has_value());
}

TEST(ReportTables, ExpectNoMoreThanTheStopNeeds) {
  CampaignResults results = EmptyCampaign(400);
  results.campaign.stop = StopRule{.half_width = 0.1, .looks = {50, 100, 200, 400}};
  AddCase({}, "", &results);
  AddPasses(
      100, [](int64_t) { return 1; }, &results);
  const ReportTables tables = MakeReportTables(results);
  EXPECT_EQ(tables.cases[0].num_expected, 100);
  EXPECT_EQ(tables.num_missing, 0);
  EXPECT_TRUE(tables.cases[0].has_stopped);
  EXPECT_TRUE(tables.cases[0].share_passed.is_repeated);
  EXPECT_GT(tables.cases[0].share_passed.confidence, 0.9999);
  EXPECT_FALSE(tables.cases[0].metrics[0].mean.is_repeated);
  results.rows.pop_back();
  EXPECT_EQ(MakeReportTables(results).num_missing, 301) << "99 do not reach the look";
}

TEST(ReportTables, NameTheLooksThatAMissingValueLeftUndecided) {
  CampaignResults results = EmptyCampaign(100);
  results.campaign.stop = StopRule{.metric = "closest_m", .half_width = 100, .looks = {50, 100}};
  AddCase({}, "", &results);
  AddPasses(
      100, [](int64_t i) { return i % 2; }, &results);
  results.rows[10].result = {};
  const ReportTables tables = MakeReportTables(results);
  EXPECT_EQ(tables.cases[0].undecidable_looks, (std::vector<int64_t>{50, 100}));
  EXPECT_TRUE(tables.cases[0].metrics[0].mean.is_repeated);
  EXPECT_FALSE(tables.cases[0].share_passed.is_repeated);
}

TEST(ReportTables, StandInfiniteValues) {
  CampaignResults results = EmptyCampaign(3);
  AddCase({}, "", &results);
  const double infinite = std::numeric_limits<double>::infinity();
  AddTrial(1, TrialOutcome::kPass, {infinite}, &results);
  AddTrial(2, TrialOutcome::kPass, {1}, &results);
  AddTrial(3, TrialOutcome::kPass, {infinite}, &results);
  const MetricSummary metric = MakeReportTables(results).cases[0].metrics[0];
  EXPECT_EQ(metric.max, infinite);
  EXPECT_EQ(metric.mean.interval, Interval());
  EXPECT_EQ(metric.worst.front().key.repetition, 2) << "infinitely far from the median";
}

}  // namespace shoal
