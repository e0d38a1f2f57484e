#include "lib/tools/moos/moos_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace shoal::moos_file_test {

TEST(ParseMoosFile, FindsGlobalsAndBlocks) {
  const MoosFile file = ParseMoosFile(
      "// a comment\n"
      "ServerHost = localhost\r\n"
      "\tCommunity=alpha// the name\n"
      "ProcessConfig = uFldNodeComms\n"
      "{\n"
      "  pulse_duration = 10;   // seconds\n"
      "  stealth = vname=alpha, stealth=0.8\n"
      "}\n"
      "processconfig = ANTLER {\n"
      "  Run = MOOSDB @ NewConsole = false ~ db\n"
      "}\n",
      "a.moos");
  EXPECT_TRUE(file.odd_lines.empty());
  ASSERT_EQ(file.globals.size(), 2U);
  EXPECT_EQ(file.globals[1].key, "Community");
  EXPECT_EQ(file.globals[1].value, "alpha");
  EXPECT_EQ(file.globals[1].number, 3);
  ASSERT_EQ(file.blocks.size(), 2U);
  EXPECT_EQ(file.blocks[0].app, "uFldNodeComms");
  EXPECT_EQ(file.blocks[0].number, 4);
  ASSERT_EQ(file.blocks[0].lines.size(), 2U);
  EXPECT_EQ(file.blocks[0].lines[0].value, "10");
  EXPECT_EQ(file.blocks[0].lines[1].value, "vname=alpha, stealth=0.8");
  EXPECT_EQ(file.blocks[1].app, "ANTLER");
  ASSERT_EQ(file.blocks[1].lines.size(), 1U);
  EXPECT_EQ(file.blocks[1].lines[0].value, "MOOSDB @ NewConsole = false ~ db");
}

std::vector<int> OddLines(std::string_view text) {
  std::vector<int> numbers;
  for (const MoosOddLine& line : ParseMoosFile(text, "a").odd_lines) {
    EXPECT_FALSE(line.reason.empty());
    numbers.push_back(line.number);
  }
  return numbers;
}

TEST(ParseMoosFile, ListsWhatOnlyNsplugUnderstands) {
  EXPECT_EQ(OddLines("#include plug.moos\nCommunity = $(VNAME)\nPort = ${X}\nA = %(B)\nC = 1\n"),
            (std::vector<int>{1, 2, 3, 4}));
}

TEST(ParseMoosFile, ListsMalformedLinesAndGoesOn) {
  EXPECT_EQ(OddLines("hello\nA = 1\n= 2\n}\n"), (std::vector<int>{1, 3, 4}));
  EXPECT_EQ(OddLines("ProcessConfig = X\n{\nno equals\nB = 2\n}\n"), (std::vector<int>{3}));
}

TEST(ParseMoosFile, ListsBlocksWithoutBraces) {
  const std::string text = "ProcessConfig = X\nA = 1\nProcessConfig = Y\n{\nB = 2\n";
  EXPECT_EQ(OddLines(text), (std::vector<int>{1, 3}));
  const MoosFile file = ParseMoosFile(text, "a");
  ASSERT_EQ(file.globals.size(), 1U);
  ASSERT_EQ(file.blocks.size(), 2U);
  EXPECT_EQ(file.blocks[1].lines.size(), 1U);
  EXPECT_EQ(OddLines("ProcessConfig = X\n{\nProcessConfig = Y\n{\n}\n"), (std::vector<int>{1}));
}

TEST(ParseMoosFile, GivesReasonsThatFinishASentenceAboutTheLine) {
  const std::string text =
      "hello\n#include plug.moos\nProcessConfig = X\nA = 1\nProcessConfig = Y\n{\nno equals\n";
  const MoosFile file = ParseMoosFile(text, "a");
  EXPECT_EQ(file.odd_lines.size(), 5U);
  for (const MoosOddLine& line : file.odd_lines) {
    EXPECT_TRUE(line.reason.starts_with("is ")) << line.reason;
  }
}

RC_GTEST_PROP(ParseMoosFile, LosesNoLineOfAnyText, ()) {
  const auto pieces = *rc::gen::container<std::vector<std::string>>(
      rc::gen::element<std::string>("ProcessConfig = X\n", "{\n", "}\n", "a = b\n", "junk\n", "\n",
                                    "#pragma\n", "// c\n", "p = $(Q)\n", "ProcessConfig=Y {\n"));
  std::string text;
  size_t num_lines = 0;
  for (const std::string& piece : pieces) {
    text += piece;
    if (piece == "a = b\n" || piece == "junk\n" || piece == "#pragma\n" || piece == "p = $(Q)\n") {
      ++num_lines;
    }
  }
  const MoosFile file = ParseMoosFile(text, "a");
  size_t num_found = file.globals.size();
  for (const MoosBlock& block : file.blocks) num_found += block.lines.size();
  for (const MoosOddLine& line : file.odd_lines) {
    if (!line.text.starts_with("ProcessConfig") && line.text != "{" && line.text != "}")
      ++num_found;
  }
  RC_ASSERT(num_found == num_lines);
}

}  // namespace shoal::moos_file_test
