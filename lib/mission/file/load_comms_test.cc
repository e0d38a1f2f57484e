#include "lib/mission/file/load_comms.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace shoal::load_comms_test {

TEST(LoadComms, ReadsAFileThatHoldsTheTableCommsAlone) {
  const LoadedComms loaded = LoadCommsText("[comms]\ncomms_range = 50\nstale_time = 3\n", "c.toml");
  ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  EXPECT_EQ(loaded.rules.comms_range_m, 50);
  EXPECT_EQ(loaded.rules.stale_forget_s, 60) << "20 times stale_time, as in a mission file";
  EXPECT_FALSE(loaded.mission);
}

TEST(LoadComms, TakesRulesAndVehiclesFromAWholeMissionFile) {
  const LoadedComms loaded = LoadCommsText(
      "[mission]\nduration_s = 9\nseed = 4\n[comms]\ngroups = true\n"
      "[[vehicle]]\nname = \"alpha\"\nstealth = 0.5\n",
      "m.toml");
  ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  EXPECT_TRUE(loaded.rules.groups);
  ASSERT_TRUE(loaded.mission);
  EXPECT_EQ(loaded.mission->seed, 4u);
  EXPECT_EQ(loaded.mission->vehicles.front().link_factors.stealth, 0.5);
}

std::string FirstError(std::string_view text) {
  const LoadedComms loaded = LoadCommsText(text, "c.toml");
  return loaded.errors.empty() ? "" : loaded.errors.front();
}

TEST(LoadComms, ReportsWhatIsWrongWithFileAndLine) {
  EXPECT_TRUE(FirstError("[comms]\ncoms_range = 50\n").starts_with("c.toml:2:1: unknown key"))
      << FirstError("[comms]\ncoms_range = 50\n");
  EXPECT_TRUE(FirstError("[comms]\ngroups = 1\n").starts_with("c.toml:2:"));
  EXPECT_NE(FirstError("").find("[comms]"), std::string::npos);
  EXPECT_NE(FirstError("[comms]\n[coms]\n").find("coms"), std::string::npos);
  EXPECT_NE(FirstError("[[vehicle]]\nname = \"a\"\n").find("[mission]"), std::string::npos);
  EXPECT_TRUE(FirstError("[comms\n").starts_with("c.toml:1:"));
}

TEST(LoadComms, NamesTheFileThatItCannotRead) {
  const LoadedComms loaded = LoadComms("/no/such/file.toml");
  ASSERT_EQ(loaded.errors.size(), 1u);
  EXPECT_TRUE(loaded.errors.front().starts_with("/no/such/file.toml")) << loaded.errors.front();
}

TEST(ExplainComms, WritesALineForEachKey) {
  const std::vector<std::string> lines = ExplainComms({.comms_range_m = 50});
  EXPECT_NE(std::find(lines.begin(), lines.end(), "comms_range = 50"), lines.end());
  std::string text = "[comms]\n";
  for (const std::string& line : lines) text += line + "\n";
  EXPECT_EQ(LoadCommsText(text, "c.toml").rules, (RoutingRules{.comms_range_m = 50}));
}

}  // namespace shoal::load_comms_test
