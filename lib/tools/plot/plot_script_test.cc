#include "lib/tools/plot/plot_script.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace shoal::plot_script_test {

bool Contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ShownText, LeavesOrdinaryNamesAsTheyAre) {
  EXPECT_EQ(ShownText("scout_01"), "scout_01");
  EXPECT_EQ(ShownText("Übung 2, süß"), "Übung 2, süß");
}

TEST(ShownText, HasNoControlsAndNothingThatIsNotUtf8) {
  EXPECT_EQ(ShownText("a\nb\x1b[31m\x7f"), "a b [31m ");
  EXPECT_EQ(ShownText("\xff\xc3(\xc0\xaf\xed\xa0\x80\xc2\x85"), "?\?(\?\?\?\?\? ");
}

TEST(ShownText, CutsWhatIsLong) {
  EXPECT_EQ(ShownText(std::string(60, 'a')), std::string(60, 'a'));
  EXPECT_EQ(ShownText(std::string(61, 'a')), std::string(59, 'a') + "…");
  EXPECT_EQ(ShownText(std::string(1'000'000, 'a')), std::string(59, 'a') + "…");
}

TEST(GnuplotString, EndsNowhereButAtItsEnd) {
  EXPECT_EQ(GnuplotString("a'; system('id'); '"), "'a''; system(''id''); '''");
  EXPECT_EQ(GnuplotString("`id` @x \\"), "'`id` @x \\'");
}

RC_GTEST_PROP(GnuplotString, IsOneStringInSingleQuotesWhateverTheName, (std::string name)) {
  const std::string quoted = GnuplotString(name);
  RC_ASSERT(quoted.size() >= 2u);
  RC_ASSERT(quoted.front() == '\'');
  RC_ASSERT(quoted.back() == '\'');
  const std::string inside = quoted.substr(1, quoted.size() - 2);
  for (size_t i = 0; i < inside.size(); ++i) {
    RC_ASSERT(static_cast<unsigned char>(inside[i]) >= 0x20u);
    if (inside[i] == '\'') {
      RC_ASSERT(i + 1 < inside.size());
      RC_ASSERT(inside[++i] == '\'');
    }
  }
}

TEST(PlotBlocks, AreApartByTwoBlankLinesAndTheirLinesByOne) {
  PlotBlocks blocks;
  EXPECT_EQ(blocks.Add("a\nb", {{{1, 2}, {3, 4}}, {{5, 6}}}), 0);
  EXPECT_EQ(blocks.Add("c", {{{0.1, 1e-7}}}), 1);
  EXPECT_EQ(blocks.text(), "# a b\n1 2\n3 4\n\n5 6\n\n\n# c\n0.1 1e-07\n");
}

TEST(Legend, TakesMoreColumnsWhereItIsLongerThanTheFigure) {
  const std::vector<LegendEntry> few(3, {"scout_01", "lines"});
  const std::vector<LegendEntry> many(50, {"scout_01", "lines"});
  EXPECT_GT(LegendWidth_px(many, 500), 2 * LegendWidth_px(few, 500));
  EXPECT_LT(LegendWidth_px({}, 500), 40);
}

// gnuplot drops entries of a legend that has more rows than fit beside the uppermost plot, or more
// columns than fit on the canvas: a row takes 20 pixels, and gnuplot keeps some of the height free.
TEST(StackedScript, HasRoomForALegendOfManyVehiclesBesideItsFirstPanel) {
  const std::vector<Panel> panels(2, {"speed [m/s]", {"'a.dat' index 0 with lines notitle"}, {}});
  const std::vector<LegendEntry> legend(60, {"vessel_01", "lines"});
  const std::string script = StackedScript("a", "A", "t", 0, 1, panels, legend, false);
  EXPECT_NE(script.find("maxrows 8 "), std::string::npos) << script;
  // 8 columns of 80 pixels and 9 characters.
  EXPECT_NE(script.find("size " + std::to_string(600 + 8 * (80 + 9 * 8) + 24) + ","),
            std::string::npos)
      << script;
}

TEST(StackedScript, SharesTheTimeAxisAndNamesItOnce) {
  const std::vector<Panel> panels = {{"speed [m/s]", {"'a.dat' index 0 with lines notitle"}, {}},
                                     {"heading [°]", {"'a.dat' index 1 with lines notitle"}, {}}};
  const std::string script = StackedScript("a", "Speed: it's mine", "time [s]", 5, 25, panels,
                                           {{"al'pha", "lines lc rgb '#ff0000'"}}, false);
  EXPECT_TRUE(Contains(script, "set terminal svg size 1000,"));
  EXPECT_TRUE(Contains(script, "set output '../a.svg'\n"));
  EXPECT_TRUE(Contains(script, "set xrange [5:25]\n"));
  EXPECT_TRUE(Contains(script, "set title 'Speed: it''s mine'\n"));
  EXPECT_TRUE(Contains(script, "keyentry with lines lc rgb '#ff0000' title 'al''pha'"));
  EXPECT_EQ(script.find("set xlabel"), script.rfind("set xlabel"));
  EXPECT_LT(script.find("set ylabel 'speed [m/s]'"), script.find("set ylabel 'heading [°]'"));
}

TEST(StackedScript, HasATimeAxisForOneMomentToo) {
  const std::vector<Panel> panels = {{"speed", {"'a.dat' index 0 with lines notitle"}, {}}};
  const std::string script = StackedScript("a", "t", "time", 5, 5, panels, {}, true);
  EXPECT_TRUE(Contains(script, "set xrange [5:5.001]\n"));
  EXPECT_TRUE(Contains(script, "set terminal pngcairo size 2000,"));
  EXPECT_TRUE(Contains(script, "set output '../a.png'\n"));
}

}  // namespace shoal::plot_script_test
