#include "lib/tools/report/compare.h"

#include <gtest/gtest.h>

#include "lib/tools/campaign/campaign_testing.h"
#include "lib/tools/report/compare_text.h"

namespace shoal {

namespace {

constexpr auto kPass = TrialOutcome::kPass;
constexpr auto kFail = TrialOutcome::kFail;

bool Contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// Two ranges, each with the policies A and B; B is 2 m farther in each repetition.
CampaignResults TwoRangesTwoPolicies() {
  CampaignResults results = EmptyCampaign(10);
  results.sweep_keys = {"comms.comms_range", "loss"};
  for (const char* range : {"50", "100"}) {
    for (const char* policy : {"A", "B"}) {
      AddCase({range, "0.1"}, policy, &results);
      const int shift = policy == std::string("B") ? 2 : 0;
      AddPasses(
          10, [&](int64_t i) { return i + shift; }, &results);
    }
  }
  return results;
}

/// One point of hand-made outcomes.
CampaignResults HandMade() {
  CampaignResults results = EmptyCampaign(6);
  AddCase({}, "A", &results);
  const std::pair<TrialOutcome, double> of_a[] = {
      {kPass, 1}, {kPass, 2}, {kFail, 3}, {kFail, 4}, {kPass, 5}, {TrialOutcome::kTimeout, 6}};
  for (int64_t i = 0; i < 6; ++i) AddTrial(i + 1, of_a[i].first, {of_a[i].second}, &results);
  AddCase({}, "B", &results);
  AddTrial(1, kPass, {1}, &results);
  AddTrial(2, kFail, {2.5}, &results);
  AddTrial(3, kPass, {3}, &results);
  AddTrial(4, kFail, {4}, &results);
  AddTrial(5, TrialOutcome::kError, {}, &results);
  return results;
}

}  // namespace

TEST(CompareCases, PairsRepetitionsOfEqualPoints) {
  const auto comparison = CompareCases(TwoRangesTwoPolicies(), "policy=A", "policy=B");
  ASSERT_TRUE(comparison.ok()) << comparison.error();
  ASSERT_EQ((*comparison).points.size(), 2U);
  const ComparedPoint& point = (*comparison).points[1];
  EXPECT_EQ(KeysText(point.rest), "comms.comms_range=100, loss=0.1");
  EXPECT_EQ(point.num_pairs, 10);
  EXPECT_EQ(point.both_pass, 10);
  EXPECT_EQ(point.metrics[0].means.interval, (Interval{2, 2}));
}

TEST(CompareCases, PairsStepsOfASweep) {
  const auto comparison = CompareCases(TwoRangesTwoPolicies(), "comms.comms_range=50, policy=A",
                                       "comms.comms_range=100.0,policy=\"B\"");
  ASSERT_TRUE(comparison.ok()) << comparison.error();
  ASSERT_EQ((*comparison).points.size(), 1U);
  EXPECT_EQ((*comparison).points[0].case_b, 3U);
}

TEST(CompareCases, CountsOutcomesWithErrorsAsNotPassed) {
  const auto comparison = CompareCases(HandMade(), "policy=A", "policy=B");
  ASSERT_TRUE(comparison.ok()) << comparison.error();
  const ComparedPoint& point = (*comparison).points.at(0);
  EXPECT_EQ(point.num_pairs, 5);
  EXPECT_EQ(point.both_pass, 1);
  EXPECT_EQ(point.only_a, 2);
  EXPECT_EQ(point.only_b, 1);
  EXPECT_EQ(point.neither, 1);
  EXPECT_EQ(point.p, 1);
  EXPECT_EQ(point.num_alone, 1) << "repetition 6 of A";
}

TEST(CompareCases, NamesPairsWithAnError) {
  const auto comparison = CompareCases(HandMade(), "policy=A", "policy=B");
  ASSERT_TRUE(comparison.ok()) << comparison.error();
  const ComparedPoint& point = (*comparison).points.at(0);
  ASSERT_EQ(point.broken.size(), 1U);
  EXPECT_EQ(point.broken[0].a, "0000000000-5");
  EXPECT_EQ(point.broken[0].b, "1111111111-5");
  EXPECT_EQ(point.broken[0].outcome_b, TrialOutcome::kError);
  EXPECT_EQ(point.metrics[0].num_without, 1);
  EXPECT_EQ(point.metrics[0].means.num_pairs, 4);
  const std::string text = ComparisonText(HandMade(), *comparison);
  EXPECT_TRUE(Contains(text, "1 pair with an error or a timeout")) << text;
  EXPECT_TRUE(Contains(text, "0000000000-5 pass, 1111111111-5 error")) << text;
  EXPECT_TRUE(Contains(text, "1 pair left out: a trial has no value")) << text;
}

TEST(CompareCases, FindsExactlyNothingWhereAKeyChangesNothing) {
  CampaignResults results = EmptyCampaign(200);
  for (const char* policy : {"A", "B"}) {
    AddCase({}, policy, &results);
    for (int64_t i = 1; i <= 200; ++i) {
      AddTrial(i, i % 7 == 0 ? kFail : kPass, {0.1 * static_cast<double>(i * i % 31)}, &results);
    }
  }
  const auto comparison = CompareCases(results, "policy=A", "policy=B");
  ASSERT_TRUE(comparison.ok()) << comparison.error();
  const ComparedPoint& point = (*comparison).points.at(0);
  EXPECT_EQ(point.only_a + point.only_b, 0);
  EXPECT_EQ(point.metrics[0].means.num_equal, 200);
  EXPECT_EQ(point.metrics[0].means.difference, 0);
  EXPECT_EQ(point.metrics[0].means.interval, (Interval{0, 0}));
  EXPECT_TRUE(Contains(ComparisonText(results, *comparison), "the same in every pair"));
}

TEST(CompareCases, WarnsOfPairsThatAreNone) {
  CampaignResults results = HandMade();
  results.rows[0].seed = 5;
  const auto comparison = CompareCases(results, "policy=A", "policy=B");
  ASSERT_TRUE(comparison.ok()) << comparison.error();
  EXPECT_EQ((*comparison).points[0].num_other_seed, 1);
}

TEST(CompareCases, NamesCasesWithoutAPartner) {
  CampaignResults results = TwoRangesTwoPolicies();
  AddCase({"200", "0.1"}, "B", &results);
  const auto comparison = CompareCases(results, "policy=A", "policy=B");
  ASSERT_TRUE(comparison.ok()) << comparison.error();
  EXPECT_EQ((*comparison).without_partner, (std::vector<size_t>{4}));
  EXPECT_TRUE(Contains(ComparisonText(results, *comparison),
                       "not compared: comms.comms_range=200, loss=0.1, policy=B"));
}

TEST(CompareCases, ListsWhatThereIsWhereNothingMatches) {
  const auto error_of = [](const char* a, const char* b) {
    const auto comparison = CompareCases(TwoRangesTwoPolicies(), a, b);
    return comparison.ok() ? std::string("no error") : comparison.error();
  };
  EXPECT_TRUE(Contains(error_of("policy=C", "policy=B"), "--a policy=C matches no case"));
  EXPECT_TRUE(Contains(error_of("policy=C", "policy=B"), "policy = A, B"));
  EXPECT_TRUE(Contains(error_of("policy=A", "range=50"), "sweeps no 'range'"));
  EXPECT_TRUE(Contains(error_of("policy=A", "range=50"), "comms.comms_range = 50, 100"));
  EXPECT_TRUE(Contains(error_of("A", "B"), "'A' is not KEY=VALUE"));
  EXPECT_TRUE(Contains(error_of("policy=A", "policy=A"), "select the same cases"));
  EXPECT_TRUE(Contains(error_of("policy=A", "policy=B,comms.comms_range=50"),
                       "--a policy=A leaves several cases"));
}

TEST(CompareCases, SplitsNoArrayAtItsCommas) {
  CampaignResults results = EmptyCampaign(1);
  results.sweep_keys = {"channels"};
  AddCase({"[1, 2]"}, "", &results);
  AddCase({"[1, 3]"}, "", &results);
  EXPECT_TRUE(CompareCases(results, "channels=[1, 2]", "channels=[1, 3]").ok());
}

}  // namespace shoal
