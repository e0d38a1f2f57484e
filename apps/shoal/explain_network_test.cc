#include "apps/shoal/explain_network.h"

#include <gtest/gtest.h>

#include "lib/mission/file/load.h"

namespace shoal::explain_network_test {

Mission LoadExample(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded =
      LoadMission(SHOAL_SOURCE_DIR "/missions/" + name + ".toml", overrides);
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  return loaded.mission;
}

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ExplainNetwork, ShowsTheChannelOfEachVehicleAndHowManyFit) {
  const std::string text = ExplainNetwork(LoadExample("swarm_fdma"));
  // floor((10 - 0.25) / (1 + 0.25)) = 7 channels of 1 kHz; the first on the base frequency.
  EXPECT_TRUE(Has(text, "access_mode fdma: 5 of at most 7 in 10 kHz around 24 kHz, 1000 bit/s"))
      << text;
  EXPECT_TRUE(Has(text, "#              1    24.000   1.00  alpha / all others\n")) << text;
  EXPECT_TRUE(Has(text, "  bravo / all others\n")) << text;
}

TEST(ExplainNetwork, ShowsWhoSendsAndReceivesOnTheTwoChannelsOfLeadersAndFollowers) {
  const std::string text = ExplainNetwork(LoadExample("swarm_tdma_lf"));
  EXPECT_TRUE(Has(text, "  alpha / all others (broadcast)\n")) << text;
  EXPECT_TRUE(Has(text, "f1, f2, f3, f4, f5, f6, f7, f8 and 1 more / alpha\n")) << text;
}

TEST(ExplainNetwork, ShowsTheLengthsThatAutoStandsForAndEveryMembersFirstSlot) {
  const std::string text = ExplainNetwork(LoadExample("swarm_fdma"));
  EXPECT_TRUE(Has(text, "fdma_lf: episode 5 s, from member to member 0.5 s\n")) << text;
  EXPECT_TRUE(Has(text, "report 0.296 s, leader's report 0.456 s")) << "37 and 57 bytes" << text;
  EXPECT_TRUE(Has(text, "#     echo                    5  2 s\n")) << text;
  const std::string asked = ExplainNetwork(LoadExample("swarm_tdma_lf"));
  EXPECT_FALSE(Has(asked, "auto")) << asked;
  EXPECT_TRUE(Has(asked, " s, when asked\n")) << asked;
}

TEST(ExplainNetwork, ShowsTheSlotsOfEachOfSeveralSwarms) {
  const std::string text = ExplainNetwork(LoadExample("two_swarms"));
  EXPECT_TRUE(Has(text, "# Slots of the swarm north (group_id A), fdma_lf: episode 5 s")) << text;
  EXPECT_TRUE(Has(text, "# Slots of the swarm south (group_id B), fdma_lf: episode 4 s")) << text;
}

TEST(ExplainNetwork, ShowsTheChannelsOfEveryAcousticMediumWithTheVehiclesThatHaveIt) {
  const LoadedMission loaded = LoadMissionText(
      "[mission]\nduration_s = 60\n[[medium]]\nname = \"deep\"\nkind = \"acoustic\"\n"
      "access_mode = \"fdma\"\n[[vehicle]]\nname = \"alpha\"\nmedia = [\"deep\"]\n"
      "[[vehicle]]\nname = \"bravo\"\nmedia = [\"direct\"]\n"
      "[[vehicle]]\nname = \"charlie\"\nmedia = [\"deep\"]\n",
      "m.toml");
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  const std::string text = ExplainNetwork(loaded.mission);
  EXPECT_TRUE(Has(text, "# Acoustic channels of the medium deep, access_mode fdma: 2 of at most 7"))
      << text;
  EXPECT_TRUE(Has(text, "  alpha / all others\n")) << text;
  EXPECT_FALSE(Has(text, "bravo")) << text;
}

TEST(ExplainNetwork, ShowsTheStrategiesOfMembersWithoutOwnOnes) {
  const std::string text = ExplainNetwork(LoadExample("swarm_fdma"));
  EXPECT_TRUE(Has(text, "Recovery of damaged fields by all: the default\n")) << text;
  EXPECT_TRUE(Has(text, "#     skip                         num_followers\n")) << text;
  const std::string own =
      ExplainNetwork(LoadExample("swarm_fdma", {"vehicle.bravo.recovery.time_stamp=[\"skip\"]"}));
  EXPECT_TRUE(Has(own, "by alpha, charlie, delta, echo: the default\n")) << own;
}

TEST(ExplainNetwork, LeavesTheExplainedMissionOneThatLoads) {
  const Mission mission = LoadExample("swarm_tdma_lf");
  const std::string text = Explain(mission) + ExplainNetwork(mission);
  EXPECT_EQ(LoadMissionText(text, "explained.toml").errors, std::vector<std::string>());
}

TEST(ExplainNetwork, IsEmptyWithoutAnAcousticNetwork) {
  EXPECT_EQ(ExplainNetwork(LoadExample("alpha")), "");
}

}  // namespace shoal::explain_network_test
