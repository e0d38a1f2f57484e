#include "lib/tools/campaign/load_campaign.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace shoal {
namespace {

LoadedCampaign Load(const std::string& text) {
  return LoadCampaignText("[campaign]\nmission = \"berta.toml\"\n" + text, "c.toml", "/missions");
}

std::string ErrorsOf(const std::string& text) {
  std::string all;
  for (const std::string& error : Load(text).errors) all += error + "\n";
  return all;
}

using Texts = std::vector<std::string>;

TEST(Range, MayBeOfNumbersThatAreHardlyAny) {
  const auto loaded = Load("[sweep]\na.b = {from = 0, to = 1e-309, steps = 3}\n");
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  ASSERT_EQ(loaded.campaign.sweep.size(), 1U);
  ASSERT_EQ(loaded.campaign.sweep[0].values.size(), 3U);
  EXPECT_EQ(std::strtod(loaded.campaign.sweep[0].values[1][0].c_str(), nullptr), 5e-310);
  EXPECT_EQ(std::strtod(loaded.campaign.sweep[0].values[2][0].c_str(), nullptr), 1e-309);
}

TEST(LoadCampaign, TakesDefaultsWhereOnlyAMissionIsGiven) {
  const LoadedCampaign loaded = Load("");
  ASSERT_EQ(loaded.errors, Texts{});
  EXPECT_EQ(loaded.campaign.mission_file, "/missions/berta.toml");
  EXPECT_EQ(loaded.campaign.repetitions, 100);
  ASSERT_EQ(loaded.campaign.policies.size(), 1U);
  EXPECT_EQ(loaded.campaign.policies[0].name, "");
}

TEST(LoadCampaign, TakesDottedAndQuotedKeysAlike) {
  const auto dotted = Load("[sweep]\ncomms.comms_range = [50, 100]\n");
  const auto quoted = Load("[sweep]\n\"comms.comms_range\" = [50, 100]\n");
  ASSERT_EQ(dotted.errors, Texts{});
  ASSERT_EQ(quoted.errors, Texts{});
  for (const Campaign& campaign : {dotted.campaign, quoted.campaign}) {
    ASSERT_EQ(campaign.sweep.size(), 1U);
    EXPECT_EQ(campaign.sweep[0].keys, Texts{"comms.comms_range"});
    EXPECT_EQ(campaign.sweep[0].values, (std::vector<Texts>{{"50"}, {"100"}}));
  }
}

TEST(LoadCampaign, WritesStepsOfARangeAsAPersonWould) {
  const auto loaded = Load("[sweep]\nacoustics.packet_loss = {from = 0.0, to = 0.4, steps = 5}\n");
  ASSERT_EQ(loaded.errors, Texts{});
  EXPECT_EQ(loaded.campaign.sweep[0].values,
            (std::vector<Texts>{{"0"}, {"0.1"}, {"0.2"}, {"0.3"}, {"0.4"}}));
}

TEST(LoadCampaign, WalksKeysTogetherInOneAxis) {
  const auto loaded =
      Load("[[sweep.together]]\n\"a.b\" = [1, 2, 3]\n\"c.d\" = {from = 10, to = 30, steps = 3}\n");
  ASSERT_EQ(loaded.errors, Texts{});
  ASSERT_EQ(loaded.campaign.sweep.size(), 1U);
  EXPECT_EQ(loaded.campaign.sweep[0].values,
            (std::vector<Texts>{{"1", "10"}, {"2", "20"}, {"3", "30"}}));
}

TEST(LoadCampaign, RefusesAKeyThatTwoTablesSet) {
  EXPECT_NE(ErrorsOf("[sweep]\n\"a.b\" = [1, 2]\n[sample]\n\"a.b\" = {uniform = [0, 1]}\n")
                .find("c.toml:6:1: 'a.b' is in [sweep] as well"),
            std::string::npos);
}

TEST(LoadCampaign, LetsPoliciesSetTheSameKey) {
  const auto loaded = Load("[policy.A]\n\"a.b\" = 1\n[policy.B]\n\"a.b\" = \"x\"\na.c = true\n");
  ASSERT_EQ(loaded.errors, Texts{});
  ASSERT_EQ(loaded.campaign.policies.size(), 2U);
  EXPECT_EQ(loaded.campaign.policies[1].settings[0].AsOverride(), "a.b=\"x\"");
  EXPECT_EQ(loaded.campaign.policies[1].settings[1].AsOverride(), "a.c=true");
}

TEST(LoadCampaign, SetsKeysOfEveryTrial) {
  const auto loaded = Load("[set]\nexpect.1.min_m = 3\n\"a.b\" = true\n");
  ASSERT_EQ(loaded.errors, Texts{});
  ASSERT_EQ(loaded.campaign.settings.size(), 2U);
  EXPECT_EQ(loaded.campaign.settings[0].AsOverride(), "expect.1.min_m=3");
  EXPECT_NE(ErrorsOf("[set]\n\"a.b\" = 1\n[policy.A]\n\"a.b\" = 2\n").find("[set] as well"),
            std::string::npos);
}

TEST(LoadCampaign, TakesTablesAsValuesOfPolicies) {
  const auto loaded = Load("[policy.A]\n\"vehicle.alpha.start\" = [1, 2.0]\n");
  ASSERT_EQ(loaded.errors, Texts{});
  EXPECT_EQ(loaded.campaign.policies[0].settings[0].value, "[1, 2.0]");
}

TEST(LoadCampaign, StatesAllThatIsWrongAtOnce) {
  const std::string errors = ErrorsOf(
      "repetitons = 5\n"
      "[sweep]\n\"a.b\" = 5\n\"mission.seed\" = [1, 2]\n"
      "[sample]\n\"c.d\" = {uniform = [3, 1]}\n\"e.f\" = {gaussian = [0, 1]}\n"
      "[stop]\nhalf_width = 0.1\nlooks = [50, 40]\n[polcy.A]\n");
  for (const char* part :
       {"c.toml:3:1: unknown key 'repetitons' (did you mean 'repetitions'?)",
        "c.toml:5:9: 'a.b' is a whole number; a sweep takes a list",
        "c.toml:6:1: the seed follows from [campaign] seed and the repetition",
        "c.toml:8:20: uniform = [FROM, TO]: TO must be larger than FROM",
        "c.toml:9:", "c.toml:12:", "unknown table [polcy] (did you mean 'policy'?)"}) {
    EXPECT_NE(errors.find(part), std::string::npos) << part << "\n in:\n" << errors;
  }
}

TEST(LoadCampaign, RefusesLooksBeyondTheRepetitions) {
  EXPECT_NE(ErrorsOf("repetitions = 100\n[stop]\nhalf_width = 0.1\nlooks = [50, 200]\n")
                .find("from 2 to the campaign's 100 repetitions"),
            std::string::npos);
}

TEST(LoadCampaign, RefusesASweepOfMillionsOfPoints) {
  std::string text = "[sweep]\n";
  for (const char* key : {"a.a", "a.b", "a.c"}) {
    text += std::string("\"") + key + "\" = {from = 0, to = 1, steps = 1000}\n";
  }
  EXPECT_NE(ErrorsOf(text).find("more than 100000 points"), std::string::npos);
}

TEST(LoadCampaign, NamesAFileThatIsNotThere) {
  const LoadedCampaign loaded = LoadCampaign("/no/such/campaign.toml");
  ASSERT_EQ(loaded.errors.size(), 1U);
  EXPECT_TRUE(loaded.errors[0].starts_with("/no/such/campaign.toml: ")) << loaded.errors[0];
}

}  // namespace
}  // namespace shoal
