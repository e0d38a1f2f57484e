#include "lib/run/verdict/fate_counts.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace shoal::fate_counts_test {

constexpr int kAll = FateCounts::kAll;

TEST(FateCounts, CountsByLinkAndCause) {
  FateCounts counts({"alpha", "bravo"});
  counts.Add("alpha", "bravo", "delivered");
  counts.Add("alpha", "bravo", "delivered");
  counts.Add("alpha", "bravo", "out_of_range");
  counts.Add("bravo", "alpha", "delivered");
  EXPECT_EQ(counts.Count(0, 1, "delivered"), 2);
  EXPECT_EQ(counts.Count(0, 1, "out_of_range"), 1);
  EXPECT_EQ(counts.Count(0, 1, "stale_receiver"), 0);
  EXPECT_EQ(counts.Count(1, 0, "delivered"), 1);
  EXPECT_EQ(counts.CountOffered(0, 1), 3);
}

TEST(FateCounts, AddsUpOverAll) {
  FateCounts counts({"alpha", "bravo", "charlie"});
  counts.Add("alpha", "bravo", "delivered");
  counts.Add("charlie", "bravo", "delivered");
  counts.Add("bravo", "alpha", "delivered");
  counts.Add("nemo", "", "invalid");
  EXPECT_EQ(counts.Count(kAll, 1, "delivered"), 2);
  EXPECT_EQ(counts.Count(1, kAll, "delivered"), 1);
  EXPECT_EQ(counts.Count(kAll, kAll, "invalid"), 1);
  EXPECT_EQ(counts.CountOffered(kAll, kAll), 4);
  EXPECT_EQ(counts.Totals(), (std::map<std::string, int64_t>{{"delivered", 3}, {"invalid", 1}}));
}

TEST(FateCounts, TakesNamesWithoutRegardToCase) {
  FateCounts counts({"Alpha", "bravo"});
  counts.Add("ALPHA", "Bravo", "delivered");
  counts.Add("alpha", "bravo", "delivered");
  EXPECT_EQ(counts.Count(0, 1, "delivered"), 2);
}

TEST(FateCounts, CountsAFateOfSeveralDestinationsAsSoMany) {
  FateCounts counts({"alpha", "bravo"});
  counts.Add("alpha", "*", "out_of_range", 7);
  counts.Add("alpha", "bravo", "out_of_range");
  EXPECT_EQ(counts.Count(0, kAll, "out_of_range"), 8);
  EXPECT_EQ(counts.Count(0, 1, "out_of_range"), 1);
}

TEST(FateCounts, IgnoresCountsThatAreNone) {
  FateCounts counts({"alpha"});
  counts.Add("alpha", "*", "delivered", 0);
  counts.Add("alpha", "*", "delivered", std::numeric_limits<int32_t>::min());
  EXPECT_TRUE(counts.Totals().empty());
  for (int i = 0; i < 3; ++i) {
    counts.Add("alpha", "*", "delivered", std::numeric_limits<int32_t>::max());
  }
  EXPECT_EQ(counts.CountOffered(kAll, kAll), 6'442'450'941);
}

TEST(FateCounts, KeepsItsSizeWhenCausesAreMadeUp) {
  FateCounts counts({"alpha"});
  for (int i = 0; i < 1000; ++i) counts.Add("alpha", "nemo", "cause " + std::to_string(i));
  EXPECT_LT(counts.Totals().size(), 40U);
  EXPECT_EQ(counts.CountOffered(kAll, kAll), 1000);
}

}  // namespace shoal::fate_counts_test
