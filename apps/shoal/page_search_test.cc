#include "apps/shoal/page_search.h"

#include <gtest/gtest.h>

namespace shoal::page_search_test {

constexpr char kNetworks[] =
    "# Networks\n"
    "\n"
    "How far a report goes.\n"
    "\n"
    "## [comms]\n"
    "\n"
    "| key | default | meaning |\n"
    "|---|---|---|\n"
    "| `comms_range` | 100 | metres, see [fates](fates.md#range); `a \\| b` |\n"
    "| `x_m`, `y_m` | 0 | |\n"
    "\n"
    "```toml\n"
    "# `comms_range` in code is not a heading\n"
    "| `hidden` | 1 | no row |\n"
    "```\n"
    "\n"
    "## Range and distance\n"
    "\n"
    "The range, the range, the range.\n";

std::vector<PageSection> Sections() {
  std::vector<PageSection> sections;
  AppendSections("missions/networks.md", kNetworks, &sections);
  return sections;
}

TEST(PageSections, BeginAtEachHeadingOutsideOfCode) {
  const std::vector<PageSection> sections = Sections();
  ASSERT_EQ(sections.size(), 3U);
  EXPECT_EQ(sections[0].heading, "Networks");
  EXPECT_EQ(sections[1].heading, "[comms]");
  EXPECT_EQ(sections[1].anchor, "comms");
  EXPECT_EQ(sections[1].line, 5);
  EXPECT_EQ(sections[2].anchor, "range-and-distance");
}

TEST(PageSections, HaveTheRowsOfTheirTablesWithoutMarksOfMarkdown) {
  const std::vector<PageSection> sections = Sections();
  ASSERT_EQ(sections[1].rows.size(), 2U);
  using Cells = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(sections[1].rows[0].cells, (Cells{{"key", "`comms_range`"},
                                              {"default", "100"},
                                              {"meaning", "metres, see fates; `a | b`"}}));
  EXPECT_EQ(sections[1].rows[1].cells, (Cells{{"key", "`x_m`, `y_m`"}, {"default", "0"}}));
}

TEST(PageSearch, FindsAKeyByTheRowThatHasIt) {
  const std::vector<PageSection> sections = Sections();
  const PageFindings found = FindInPages(sections, "Comms_Range");
  ASSERT_EQ(found.rows.size(), 1U);
  EXPECT_EQ(found.rows[0].section, &sections[1]);
  EXPECT_TRUE(found.headings.empty());
  EXPECT_TRUE(found.texts.empty());
  EXPECT_EQ(FindInPages(sections, "y_m").rows.size(), 1U);
  EXPECT_EQ(FindInPages(sections, "hidden").rows.size(), 0U);
}

TEST(PageSearch, FindsAHeadingByItsWords) {
  const std::vector<PageSection> sections = Sections();
  const PageFindings found = FindInPages(sections, "[comms]");
  ASSERT_EQ(found.headings.size(), 1U);
  EXPECT_EQ(found.headings[0], &sections[1]);
  EXPECT_TRUE(FindInPages(sections, "network").headings.empty()) << "part of a word";
}

TEST(PageSearch, FindsTextsWithAllWordsTheMostFrequentFirst) {
  const std::vector<PageSection> sections = Sections();
  const PageFindings found = FindInPages(sections, "the  range");
  ASSERT_EQ(found.texts.size(), 1U);
  EXPECT_EQ(found.texts[0], &sections[2]);
  const PageFindings reports = FindInPages(sections, "report");
  ASSERT_EQ(reports.texts.size(), 1U);
  EXPECT_EQ(reports.texts[0], &sections[0]);
  EXPECT_TRUE(FindInPages(sections, "range submarine").texts.empty());
  EXPECT_TRUE(FindInPages(sections, "  ").texts.empty());
}

TEST(PageSearch, LeavesTheIndexOfKeysOut) {
  std::vector<PageSection> sections;
  AppendSections("reference/mission_keys.md", kNetworks, &sections);
  EXPECT_TRUE(FindInPages(sections, "comms_range").rows.empty());
}

TEST(PlainLine, TurnsLinksIntoTheirTexts) {
  EXPECT_EQ(PlainLine("see [the `x`](a.md#b), **bold**"), "see the `x`, bold");
  EXPECT_EQ(PlainLine("`[[x, y], ...]` in [viewer](v.md)"), "`[[x, y], ...]` in viewer");
  EXPECT_EQ(PlainLine("[0, 5] and (0, 5]"), "[0, 5] and (0, 5]");
}

}  // namespace shoal::page_search_test
