#include "lib/tools/plot/plot_colors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
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

/// Returns the least distance of two of the colours, each of whose parts is in [0, 1].
double LeastDifference(const std::vector<std::string>& colors) {
  double least = 2;
  for (size_t i = 0; i < colors.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      const auto part = [&](size_t which, int shift) {
        return static_cast<double>((*ColorOf(colors[which]) >> shift) & 0xff) / 255;
      };
      least = std::min(least, std::hypot(part(i, 0) - part(k, 0), part(i, 8) - part(k, 8),
                                         part(i, 16) - part(k, 16)));
    }
  }
  return least;
}

TEST(AssignColors, GivesTwoOrThreeVehiclesOfOneColourClearlyDifferentOnes) {
  for (const char* name : {"yellow", "white", "black", "red", "dodgerblue", ""}) {
    for (const size_t count : {2, 3}) {
      EXPECT_GT(LeastDifference(AssignColors(std::vector<std::string>(count, name))), 0.35) << name;
    }
  }
  EXPECT_GT(LeastDifference(AssignColors(std::vector<std::string>(21, "yellow"))), 0.2);
}

TEST(AssignColors, GivesAColourToTheFirstThatRequestsIt) {
  const auto colors = AssignColors({"seagreen", "seagreen", "red", "seagreen"});
  EXPECT_EQ(std::set<std::string>(colors.begin(), colors.end()).size(), 4u);
  EXPECT_EQ(colors[0], "#2e8b57");
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
