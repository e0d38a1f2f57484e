#include "apps/shoal/docs_command.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace shoal::docs_command_test {

namespace fs = std::filesystem;

constexpr char kDocs[] = SHOAL_SOURCE_DIR "/docs";

std::string TextFor(const std::string& words) {
  const auto sections = ReadPages(kDocs);
  EXPECT_TRUE(sections.ok()) << sections.error();
  return sections.ok() ? DocsText(FindInPages(*sections, words), "/docs") : "";
}

TEST(DocsCommand, PrintsTheRowOfAKeyWithItsPlace) {
  const std::string text = TextFor("comms_range");
  EXPECT_TRUE(text.starts_with("[comms]  (/docs/missions/networks.md:")) << text;
  EXPECT_NE(text.find("\n    key: `comms_range`\n    default: "), text.npos) << text;
  EXPECT_EQ(text.find("]("), text.npos) << text;
}

TEST(DocsCommand, PrintsTheSectionOfATable) {
  const std::string text = TextFor("[[obstacle]]");
  EXPECT_TRUE(text.starts_with("[[obstacle]]  (/docs/missions/environment.md:")) << text;
}

TEST(DocsCommand, ListsAtMostTenPlacesOfWordsThatNoHeadingHas) {
  const std::string text = TextFor("vehicle receives");
  EXPECT_EQ(text.find("key: "), text.npos) << text;
  EXPECT_EQ(std::ranges::count(text, '\n'), 11) << text;
  EXPECT_NE(text.find("\nand "), text.npos) << text;
  EXPECT_EQ(TextFor("sidelobe multicast"), "");
}

/// Each key of the index of keys is one for which `shoal docs` has an answer.
TEST(DocsCommand, KnowsEachKeyOfTheIndex) {
  const auto sections = ReadPages(kDocs);
  ASSERT_TRUE(sections.ok()) << sections.error();
  size_t num_keys = 0;
  for (const PageSection& section : *sections) {
    if (section.page != "reference/mission_keys.md") continue;
    for (const PageRow& row : section.rows) {
      std::string key = row.cells.front().second;
      std::erase(key, '`');
      EXPECT_FALSE(FindInPages(*sections, key).rows.empty()) << key;
      ++num_keys;
    }
  }
  EXPECT_GT(num_keys, 500U);
}

TEST(DocsCommand, OpensTheSitesPageWhereItIsInstalled) {
  const fs::path folder =
      fs::temp_directory_path() / ("shoal_docs_command." + std::to_string(getpid()));
  fs::create_directories(folder / "missions");
  std::ofstream(folder / "index.md") << "# All\n";
  std::ofstream(folder / "missions/a.md") << "# A\n\n## [b c]\n";
  const auto sections = ReadPages(folder.string());
  ASSERT_TRUE(sections.ok()) << sections.error();
  const PageFindings found = FindInPages(*sections, "[b c]");
  EXPECT_EQ(PlaceToOpen(found, folder.string()), (folder / "missions/a.md").string());
  fs::create_directories(folder / "html/docs/missions");
  std::ofstream(folder / "html/docs/missions/a.html") << "x";
  EXPECT_EQ(PlaceToOpen(found, folder.string()),
            (folder / "html/docs/missions/a.html").string() + "#b-c");
  EXPECT_EQ(PlaceToOpen({}, folder.string()), (folder / "index.md").string());
  fs::remove(folder / "index.md");
  EXPECT_NE(ReadPages(folder.string()).error().find("index.md is missing"), std::string::npos);
  fs::remove_all(folder);
}

}  // namespace shoal::docs_command_test
