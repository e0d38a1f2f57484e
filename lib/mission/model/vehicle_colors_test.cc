#include "lib/mission/model/vehicle_colors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace shoal::vehicle_colors_test {

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

TEST(ChooseColors, LeavesWhatAVehicleAloneRequestsAsItIs) {
  EXPECT_EQ(ChooseColors({"yellow", "white"}), (std::vector<uint32_t>{0xffff00, 0xffffff}));
  EXPECT_EQ(ColorText(0x00ff01), "#00ff01");
}

TEST(ChooseColors, GivesOneColourFromTwoVehiclesOnForPlotsAndViewer) {
  const auto plotted = AssignColors({"yellow", "yellow", "red"});
  const auto chosen = ChooseColors({"yellow", "yellow", "red"});
  EXPECT_EQ(chosen[0], 0xffff00u);
  EXPECT_EQ(plotted[0], "#bbbb00") << "the same, darker";
  for (const size_t i : {1, 2}) EXPECT_EQ(ColorText(chosen[i]), plotted[i]);
}

TEST(ChooseColors, DifferOnTheViewersDarkGroundToo) {
  std::vector<std::string> texts;
  for (const uint32_t color : ChooseColors(std::vector<std::string>(12, "yellow"))) {
    // As web/colors.js does: mixed with white until it is light enough.
    double amount = 0;
    const auto part = [&](int shift) {
      const double own = static_cast<double>((color >> shift) & 0xff) / 255;
      return own + (1 - own) * amount;
    };
    const auto linear = [](double value) {
      return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    while (0.2126 * linear(part(16)) + 0.7152 * linear(part(8)) + 0.0722 * linear(part(0)) < 0.2) {
      amount += 0.04;
    }
    const auto byte = [&](int shift) { return static_cast<uint32_t>(part(shift) * 255); };
    texts.push_back(ColorText(byte(16) << 16 | byte(8) << 8 | byte(0)));
  }
  EXPECT_GT(LeastDifference(texts), 0.15);
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

}  // namespace shoal::vehicle_colors_test
