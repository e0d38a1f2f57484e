#include "lib/tools/campaign/case_labels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/tools/campaign/campaign_testing.h"

namespace shoal {

namespace {

CampaignResults OneCase(const std::string& value, const std::string& policy) {
  CampaignResults results = EmptyCampaign(1);
  results.sweep_keys = {"comms.comms_range"};
  AddCase({value}, policy, &results);
  return results;
}

}  // namespace

TEST(CaseLabels, NameKeysAndPolicy) {
  const CampaignResults results = OneCase("50", "A");
  EXPECT_EQ(KeysText(KeysOf(results, results.cases[0])), "comms.comms_range=50, policy=A");
  EXPECT_EQ(ShortLabel(results, results.cases[0], 28), "50 A");
}

TEST(CaseLabels, OfACampaignWithoutKeysAreAll) {
  CampaignResults results = EmptyCampaign(1);
  AddCase({}, "", &results);
  EXPECT_EQ(KeysText(KeysOf(results, results.cases[0])), "all");
  EXPECT_EQ(ShortLabel(results, results.cases[0], 28), "all");
}

TEST(CaseLabels, StayApartWhereTheyAreCut) {
  const CampaignResults results = OneCase(std::string(70, 'x'), "");
  EXPECT_EQ(ShortLabel(results, results.cases[0], 28), std::string(16, 'x') + "… 0000000000");
}

TEST(IsSameValue, TakesTextsNumbersAndQuotes) {
  EXPECT_TRUE(IsSameValue("colregs", "\"colregs\""));
  EXPECT_TRUE(IsSameValue("50", "50.0"));
  EXPECT_TRUE(IsSameValue("1e3", "1_000"));
  EXPECT_FALSE(IsSameValue("50", "500"));
  EXPECT_FALSE(IsSameValue("nolimit", "nolimits"));
  EXPECT_FALSE(IsSameValue("nan", "inf"));
}

TEST(NumberOf, IsNoneOfWhatIsNoNumber) {
  EXPECT_EQ(NumberOf("+5"), 5);
  EXPECT_TRUE(std::isnan(NumberOf("5 m")));
  EXPECT_TRUE(std::isnan(NumberOf("")));
  EXPECT_TRUE(std::isnan(NumberOf("\"5\"")));
}

}  // namespace shoal
