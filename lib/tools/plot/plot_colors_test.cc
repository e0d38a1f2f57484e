#include "lib/tools/plot/plot_colors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

namespace shoal::plot_colors_test {

TEST(ColorOf, KnowsCssNamesHoweverTheyAreWritten) {
  EXPECT_EQ(ColorOf("dodgerblue"), 0x1e90ffu);
  EXPECT_EQ(ColorOf("Dodger_Blue"), 0x1e90ffu);
  EXPECT_EQ(ColorOf("light grey"), 0xd3d3d3u);
  EXPECT_EQ(ColorOf("#12aBf0"), 0x12abf0u);
}

TEST(ColorOf, KnowsNothingElse) {
  for (const char* name : {"", "#", "#12345", "#12345g", "nocolour", "red'; system('id')"}) {
    EXPECT_EQ(ColorOf(name), std::nullopt) << name;
  }
}

TEST(AssignColors, GivesEachItsOwn) {
  EXPECT_EQ(AssignColors({"dodgerblue", "firebrick"}),
            (std::vector<std::string>{"#1e90ff", "#b22222"}));
}

TEST(AssignColors, DarkensWhatWhitePaperWouldSwallow) {
  EXPECT_EQ(AssignColors({"yellow"}), std::vector<std::string>{"#bbbb00"});
  EXPECT_EQ(AssignColors({"white"}), std::vector<std::string>{"#adadad"});
}

TEST(AssignColors, GivesShadesToVehiclesOfTheSameColour) {
  const auto colors = AssignColors({"seagreen", "seagreen", "red", "seagreen"});
  EXPECT_EQ(std::set<std::string>(colors.begin(), colors.end()).size(), 4u);
  EXPECT_EQ(colors[1], "#2e8b57");
  EXPECT_EQ(colors[2], "#ff0000");
}

TEST(AssignColors, GivesAFleetOfOneColourManyColours) {
  const auto colors = AssignColors(std::vector<std::string>(40, "yellow"));
  EXPECT_EQ(std::set<std::string>(colors.begin(), colors.end()).size(), 40u);
}

TEST(AssignColors, GivesNoOtherVehicleAColourLikeARequestedOne) {
  const auto colors = AssignColors({"red", "", "", "", "", "", "steelblue"});
  EXPECT_EQ(std::count(colors.begin(), colors.end(), "#c51b3a"), 0);
  EXPECT_EQ(std::count(colors.begin(), colors.end(), "#1f77b4"), 0);
}

RC_GTEST_PROP(AssignColors, GivesEveryVehicleAColourThatIsOne,
              (std::vector<std::string> requested)) {
  const auto colors = AssignColors(requested);
  RC_ASSERT(colors.size() == requested.size());
  for (const std::string& color : colors) RC_ASSERT(ColorOf(color).has_value());
}

}  // namespace shoal::plot_colors_test
