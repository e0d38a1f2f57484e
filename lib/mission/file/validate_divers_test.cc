// Vessels that keep clear of what passes far below them.
#include <gtest/gtest.h>

#include <string>

#include "lib/mission/file/load.h"

namespace shoal::validate_divers_test {

/// A boat with one behavior above a diver whose path is `depth_m` deep.
std::string WarningsOf(const std::string& behavior, const std::string& depth_m = "20") {
  const LoadedMission loaded = LoadMissionText(
      "[mission]\nduration_s = 600\n"
      "[[vehicle]]\nname = \"boat\"\nbehavior = [{" +
          behavior +
          "}]\n"
          "[[vehicle]]\nname = \"auv\"\nmodel = \"remus100\"\nstart = {x_m = 300}\n"
          "[[vehicle.task]]\nkind = \"path_follow\"\npoints = [[300, 100, " +
          depth_m + "]]\n",
      "m.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  std::string text;
  for (const std::string& warning : loaded.warnings) {
    if (warning.find("keeps clear") != std::string::npos) text += warning + "\n";
  }
  return text;
}

const std::string kFlat = "vertical_separation = -1, ";
const std::string kAvoid = kFlat + "kind = \"avoid_collision\", name = \"clear\", contact = ";

TEST(Divers, FarBelowABoatThatKeepsClearOfThemAreWarnedOf) {
  EXPECT_EQ(WarningsOf(kAvoid + "\"auv\""),
            "m.toml:5:47: warning: clear keeps clear of auv as if both were at one depth, but "
            "their tasks are 10 m or more apart: write vertical_separation = 10, or leave contacts "
            "out by ignore_name = [...]\n");
  EXPECT_NE(WarningsOf(kFlat + "kind = \"colregs\", name = \"rules\", contact = \"auv\""), "");
  EXPECT_NE(
      WarningsOf("kind = \"colregs\", contact = \"auv\", name = \"a\", vertical_separation = 21"),
      "");
  EXPECT_EQ(
      WarningsOf("kind = \"colregs\", contact = \"auv\", name = \"a\", vertical_separation = 20"),
      "");
}

TEST(Divers, AreNotKeptClearOfByDefault) {
  EXPECT_EQ(WarningsOf("kind = \"colregs\", name = \"rules\", contact = \"auv\""), "");
}

TEST(Divers, NearTheSurfaceOrOfOtherBehaviorsAreNoneToWarnOf) {
  EXPECT_EQ(WarningsOf(kAvoid + "\"auv\"", "9.9"), "");
  EXPECT_EQ(WarningsOf("kind = \"trail\", name = \"after\", contact = \"auv\""), "");
}

TEST(Divers, OfARecipeAreThoseThatItsFiltersPass) {
  const std::string recipe = kFlat + "kind = \"colregs\", name = \"rules\", templating = \"spawn\"";
  EXPECT_NE(WarningsOf(recipe), "");
  EXPECT_EQ(WarningsOf(recipe + ", ignore_name = [\"auv\"]"), "");
  EXPECT_EQ(WarningsOf(recipe + ", match_name = [\"other\"]"), "");
}

}  // namespace shoal::validate_divers_test
