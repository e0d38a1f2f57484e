#include "lib/tools/trials/trial_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shoal {
namespace {

const std::vector<MetricName> kNames = {{"expect_1", "m", ""}, {"age", "s", ""}};

FinishedTrial Trial() {
  return {.key = {"4f2a91c3e0", 17},
          .result = {.outcome = TrialOutcome::kFail,
                     .why = "line one\nwith \"quotes\" and a tab\t",
                     .metrics = {7.25, TrialResult::kNoValue}},
          .wall_s = 0.0213,
          .attempt = 2};
}

TEST(TrialLine, ReadsBackAsItWasWritten) {
  const std::string line = TrialLine(Trial(), kNames);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const auto trial = ParseTrialLine(line, kNames);
  ASSERT_TRUE(trial);
  EXPECT_EQ(trial->key, Trial().key);
  EXPECT_EQ(trial->result.outcome, TrialOutcome::kFail);
  EXPECT_EQ(trial->result.why, Trial().result.why);
  EXPECT_EQ(trial->result.metrics[0], 7.25);
  EXPECT_TRUE(std::isnan(trial->result.metrics[1]));
  EXPECT_EQ(trial->attempt, 2);
}

TEST(TrialLine, IsNeverLongerThanItsReaderTakes) {
  FinishedTrial trial = Trial();
  trial.result.why = std::string(1'000'000, '\x01');
  const std::string line = TrialLine(trial, kNames);
  EXPECT_LT(line.size(), kLongestTrialLine_bytes);
  EXPECT_TRUE(ParseTrialLine(line, kNames));
}

TEST(TrialLine, StatesBytesThatAreNoTextInAWayThatCanBeRead) {
  FinishedTrial trial = Trial();
  trial.result.why = "crash \xff\xfe";
  EXPECT_TRUE(ParseTrialLine(TrialLine(trial, kNames), kNames));
}

TEST(TrialLine, IsNoTrialWhereItIsTornAnywhere) {
  const std::string line = TrialLine(Trial(), kNames);
  for (size_t size = 0; size < line.size(); ++size) {
    EXPECT_FALSE(ParseTrialLine(line.substr(0, size), kNames)) << size;
  }
}

TEST(TrialLine, IsNoTrialOfOtherMetricsOrOutcomes) {
  const std::string line = TrialLine(Trial(), kNames);
  EXPECT_FALSE(ParseTrialLine(line, {{"expect_1", "", ""}}));
  EXPECT_FALSE(ParseTrialLine(line, {{"expect_1", "", ""}, {"other", "", ""}}));
  for (const char* other : {R"({"case":"a","repetition":0,"outcome":"pass","why":"","metrics":{}})",
                            R"({"case":"a","repetition":1,"outcome":"good","why":"","metrics":{}})",
                            R"({"case":1,"repetition":1,"outcome":"pass","why":"","metrics":{}})",
                            "[]", "null", "{}"}) {
    EXPECT_FALSE(ParseTrialLine(other, kNames)) << other;
  }
}

TEST(TrialLine, OfAnErrorHasNoValues) {
  const FinishedTrial error{.key = {"aa", 1},
                            .result = {.outcome = TrialOutcome::kError, .why = "x", .metrics = {}}};
  const auto trial = ParseTrialLine(TrialLine(error, kNames), kNames);
  ASSERT_TRUE(trial);
  ASSERT_EQ(trial->result.metrics.size(), 2U);
  EXPECT_TRUE(std::isnan(trial->result.metrics[0]));
}

}  // namespace
}  // namespace shoal
