#include "lib/tools/campaign/stopping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "lib/base/statistics/coverage_testing.h"
#include "lib/base/statistics/mean_interval.h"
#include "lib/base/statistics/share_interval.h"

namespace shoal {

namespace {

constexpr double kGap = TrialResult::kNoValue;

StopRule RuleOf(const std::string& metric, double half_width) {
  return {.metric = metric, .half_width = half_width, .looks = {50, 100, 200, 400}};
}

/// Returns the share of simulated campaigns of a mean in which the interval at the stop covers.
double CoverageOfAMean(const std::string& name, const StopRule& rule) {
  const Stopping stopping(rule, 400);
  std::vector<double> values(400);
  return MeasureCoverage(name, [&](Stream* stream) {
    for (double& value : values) value = 5 + stream->Normal();
    const int64_t num = stopping.StopsAfter(values).value_or(400);
    const auto first = std::span(values).first(static_cast<size_t>(num));
    return MeanInterval(MomentsOf(first), stopping.ConfidenceAt(num)).Contains(5);
  });
}

/// Likewise of a share: a whole campaign by StopsAfter.
double CoverageOfAShare(const std::string& name, const StopRule& rule, double p) {
  const Stopping stopping(rule, 400);
  std::vector<double> values(400);
  return MeasureCoverage(name, [&](Stream* stream) {
    for (double& value : values) value = stream->Uniform() < p ? 1 : 0;
    const int64_t num = stopping.StopsAfter(values).value_or(400);
    int64_t num_passes = 0;
    for (int64_t i = 0; i < num; ++i) num_passes += values[static_cast<size_t>(i)] == 1 ? 1 : 0;
    return ShareInterval(num_passes, num, stopping.ConfidenceAt(num)).Contains(p);
  });
}

}  // namespace

TEST(Stopping, StopsAtTheFirstLookThatIsNarrowEnough) {
  // The half widths of 50, 100, 200 and 400 passes are 0.224, 0.083, 0.023 and 0.006.
  const std::vector<double> passes(400, 1);
  EXPECT_EQ(StopsAfter(RuleOf("pass", 0.3), 400, passes), 50);
  EXPECT_EQ(StopsAfter(RuleOf("pass", 0.1), 400, passes), 100);
  EXPECT_EQ(StopsAfter(RuleOf("pass", 0.04), 400, passes), 200);
  EXPECT_EQ(StopsAfter(RuleOf("pass", 0.0001), 400, passes), std::nullopt);
}

TEST(Stopping, DoesNotLookBetweenLooks) {
  const std::vector<double> passes(400, 1);
  const std::span<const double> values = passes;
  EXPECT_EQ(StopsAfter(RuleOf("pass", 0.3), 400, values.first(49)), std::nullopt);
  EXPECT_EQ(StopsAfter(RuleOf("pass", 0.1), 400, values.first(99)), std::nullopt);
}

TEST(Stopping, DoesNotDependOnWhatCameLater) {
  std::vector<double> values(400, 1);
  for (size_t i = 100; i < 400; ++i) values[i] = static_cast<double>(i % 2);
  EXPECT_EQ(StopsAfter(RuleOf("pass", 0.1), 400, values), 100);
}

TEST(Stopping, CountsAllButAPassAgainstTheShare) {
  for (const auto outcome : {TrialOutcome::kFail, TrialOutcome::kError, TrialOutcome::kTimeout}) {
    EXPECT_EQ(StopValueOf(RuleOf("pass", 0.1), 0, {.outcome = outcome, .why = "", .metrics = {7}}),
              0);
  }
  EXPECT_EQ(StopValueOf(RuleOf("pass", 0.1), 0,
                        {.outcome = TrialOutcome::kPass, .why = "", .metrics = {7}}),
            1);
}

TEST(Stopping, TakesTheMetricOfAMean) {
  const TrialResult result{.outcome = TrialOutcome::kFail, .why = "", .metrics = {7, 8}};
  EXPECT_EQ(StopValueOf(RuleOf("age_s", 0.1), 1, result), 8);
  EXPECT_TRUE(std::isnan(StopValueOf(RuleOf("age_s", 0.1), 1, TrialResult())));
}

TEST(Stopping, GoesOnWhereATrialHasNoValue) {
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) values.push_back(i % 2);
  ASSERT_EQ(StopsAfter(RuleOf("age_s", 0.6), 400, values), 50);
  values[30] = kGap;
  const Stopping stopping(RuleOf("age_s", 0.6), 400);
  EXPECT_EQ(stopping.StopsAfter(values), std::nullopt);
  EXPECT_EQ(stopping.UndecidableLooks(values), (std::vector<int64_t>{50, 100, 200, 400}));
  values[30] = 0;
  values[60] = kGap;
  EXPECT_EQ(stopping.StopsAfter(values), 50) << "a gap after the look does not matter";
  EXPECT_TRUE(stopping.UndecidableLooks(values).empty());
}

TEST(Stopping, ConcludesNothingFromOneTrial) {
  StopRule rule = RuleOf("age_s", 0.5);
  rule.looks = {1, 400};
  EXPECT_EQ(StopsAfter(rule, 400, std::vector<double>{3}), std::nullopt);
}

TEST(Stopping, UsesTheConfidenceOfTheLastLookThatWasReached) {
  const Stopping stopping(RuleOf("pass", 0.1), 400);
  EXPECT_EQ(stopping.ConfidenceAt(7), stopping.ConfidenceAt(50));
  EXPECT_EQ(stopping.ConfidenceAt(199), stopping.ConfidenceAt(100));
  EXPECT_GT(stopping.ConfidenceAt(100), stopping.ConfidenceAt(200));
  EXPECT_GT(stopping.ConfidenceAt(400), 0.95);
}

TEST(Stopping, LeavesAShareOfTheErrorForTheEndOfAllRepetitions) {
  const Stopping stopping(RuleOf("pass", 0.1), 1000);
  EXPECT_GT(stopping.ConfidenceAt(400), stopping.ConfidenceAt(1000));
}

class StoppingCoverage : public ::testing::TestWithParam<std::tuple<Spending, double>> {};

// Widths about those of the second to the last look: the deviation that was met decides.
using StoppingCoverageOfMeans = StoppingCoverage;
TEST_P(StoppingCoverageOfMeans, IsAtLeastTheConfidence) {
  const auto [spending, half_width] = GetParam();
  StopRule rule = RuleOf("age_s", half_width);
  rule.spending = spending;
  const std::string name = fmt::format("stop_mean_{}_w{}", static_cast<int>(spending), half_width);
  EXPECT_GE(CoverageOfAMean(name, rule), LeastCoverage(0.95));
}

INSTANTIATE_TEST_SUITE_P(HalfWidths, StoppingCoverageOfMeans,
                         ::testing::Combine(::testing::Values(Spending::kObrienFleming,
                                                              Spending::kPocock),
                                            ::testing::Values(0.11, 0.15, 0.2, 0.3)));

using StoppingCoverageOfShares = StoppingCoverage;
TEST_P(StoppingCoverageOfShares, IsAtLeastTheConfidence) {
  const auto [spending, p] = GetParam();
  StopRule rule = RuleOf("pass", 0.06);
  rule.spending = spending;
  const std::string name = fmt::format("stop_share_{}_p{}", static_cast<int>(spending), p);
  EXPECT_GE(CoverageOfAShare(name, rule, p), LeastCoverage(0.95));
}

INSTANTIATE_TEST_SUITE_P(Shares, StoppingCoverageOfShares,
                         ::testing::Combine(::testing::Values(Spending::kObrienFleming,
                                                              Spending::kPocock),
                                            ::testing::Values(0.01, 0.1, 0.5, 0.9)));

// The harm of peeking, at its plainest: go on until the interval leaves out a claim that is true.
TEST(Peeking, ErrsFarMoreOftenThanSpending) {
  const StopRule rule = RuleOf("age_s", 0);
  const Stopping stopping(rule, 400);
  std::vector<double> values(400);
  int num_errs_by_peeking = 0;
  const double covered = MeasureCoverage("spending_covers", [&](Stream* stream) {
    for (double& value : values) value = 5 + stream->Normal();
    bool peeking_errs = false;
    bool spending_errs = false;
    for (const int64_t look : rule.looks) {
      const Moments moments = MomentsOf(std::span(values).first(static_cast<size_t>(look)));
      if (!MeanInterval(moments, rule.confidence).Contains(5)) peeking_errs = true;
      if (!MeanInterval(moments, stopping.ConfidenceAt(look)).Contains(5)) spending_errs = true;
    }
    if (peeking_errs) ++num_errs_by_peeking;
    return !spending_errs;
  });
  const double peeking = static_cast<double>(num_errs_by_peeking) / kSimulatedCampaigns;
  RecordProperty("peeking_errs", std::to_string(peeking));
  EXPECT_GT(peeking, 0.11);
  EXPECT_GE(covered, LeastCoverage(0.95));
}

}  // namespace shoal
