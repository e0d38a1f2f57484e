#include "lib/tools/rebroker/decision_comparison.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace shoal::decision_comparison_test {

fate_t Fate(int64_t number, const std::string& destination, const std::string& cause) {
  fate_t fate{};
  fate.kind = "report";
  fate.source = "alpha";
  fate.destination = destination;
  fate.count = 1;
  fate.number = number;
  fate.cause = cause;
  fate.range_m = 12.5;
  fate.limit_m = fate.age_s = fate.age_limit_s = fate.wait_s = fate.loss_pct = -1;
  fate.length_bytes = fate.length_limit_bytes = -1;
  return fate;
}

const std::vector<fate_t> kTwo = {Fate(3, "bravo", "delivered"), Fate(3, "charlie", "dropped")};

TEST(DecisionComparison, FindsEqualStepsEqual) {
  DecisionComparison comparison(SameDecision::kWhole);
  comparison.Compare(0, kTwo, kTwo);
  comparison.Compare(100'000, {}, {});
  EXPECT_TRUE(comparison.IsEqual());
  EXPECT_EQ(comparison.num_reproduced(), 2);
  EXPECT_EQ(comparison.first_difference(), "");
}

TEST(DecisionComparison, ShowsTheFirstDifferenceOnly) {
  DecisionComparison comparison(SameDecision::kWhole);
  std::vector<fate_t> other = kTwo;
  other[1].range_m = 12.6;
  comparison.Compare(1'500'000, kTwo, other);
  comparison.Compare(1'600'000, kTwo, {});
  EXPECT_FALSE(comparison.IsEqual());
  EXPECT_EQ(comparison.num_recorded(), 4);
  EXPECT_EQ(comparison.num_reproduced(), 1);
  EXPECT_EQ(comparison.first_difference(),
            "  1.500 s, recorded: report 3 alpha -> charlie: dropped range_m=12.5\n"
            "  1.500 s, now:      report 3 alpha -> charlie: dropped range_m=12.6\n");
}

TEST(DecisionComparison, CountsWhatIsThereAmongMoreAndAmongFewer) {
  DecisionComparison comparison(SameDecision::kWhole);
  comparison.Compare(0, kTwo, {&kTwo[1], 1});
  EXPECT_EQ(comparison.num_reproduced(), 1);
  comparison.Compare(1, {&kTwo[1], 1}, kTwo);
  EXPECT_EQ(comparison.num_reproduced(), 2);
  EXPECT_EQ(comparison.num_now(), 3);
  EXPECT_FALSE(comparison.IsEqual());
}

TEST(DecisionComparison, MindsTheOrder) {
  DecisionComparison comparison(SameDecision::kWhole);
  comparison.Compare(0, kTwo, std::vector<fate_t>{kTwo[1], kTwo[0]});
  EXPECT_EQ(comparison.num_reproduced(), 0);
}

TEST(DecisionComparison, LeavesNumbersAsideWhereReportsWereLost) {
  DecisionComparison comparison(SameDecision::kWithoutNumbers);
  comparison.Compare(0, std::vector<fate_t>{Fate(3, "bravo", "delivered")},
                     std::vector<fate_t>{Fate(2, "bravo", "delivered")});
  EXPECT_TRUE(comparison.IsEqual());
  comparison.Compare(0, std::vector<fate_t>{Fate(3, "bravo", "delivered")},
                     std::vector<fate_t>{Fate(3, "bravo", "dropped")});
  EXPECT_FALSE(comparison.IsEqual());
}

TEST(DecisionComparison, OfALiveBrokerComparesFatesAndNothingElse) {
  DecisionComparison comparison(SameDecision::kFateOnly);
  std::vector<fate_t> other = {kTwo[1], kTwo[0]};
  other[0].age_s = 0.3;
  comparison.Compare(0, kTwo, other);
  EXPECT_TRUE(comparison.IsEqual());
  other[0].cause = "delivered";
  comparison.Compare(0, kTwo, other);
  EXPECT_EQ(comparison.num_reproduced(), 3);
}

TEST(FateLine, EscapesUnprintableText) {
  fate_t fate = Fate(1, "bra\nvo\x1b[2J", "delivered");
  fate.range_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(FateLine(fate), "report 1 alpha -> bra?vo?[2J: delivered range_m=nan");
}

}  // namespace shoal::decision_comparison_test
