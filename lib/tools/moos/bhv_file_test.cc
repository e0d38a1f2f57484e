#include "lib/tools/moos/bhv_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace shoal::bhv_file_test {

BhvFile Parse(const std::string& text, const MoosDefines& defines = {}) {
  return ParseBhvFile(Plug({.name = "a", .text = text}, defines, {}));
}

TEST(ParseBhvFile, FindsInitialValues) {
  const BhvFile file =
      Parse("initialize A = true, B=2 , C = \"x, y\"\ninitialize_ D = 1\nINITIALIZE E = f\n");
  EXPECT_TRUE(file.odd_lines.empty());
  ASSERT_EQ(file.initials.size(), 5U);
  EXPECT_EQ(file.initials[1].key, "B");
  EXPECT_EQ(file.initials[1].value, "2");
  EXPECT_EQ(file.initials[2].value, "\"x, y\"");
  EXPECT_EQ(file.initials[4].origin, "a:3");
}

TEST(ParseBhvFile, FindsModesHoweverTheirBracesStand) {
  const BhvFile file = Parse(
      "set MODE = ACTIVE {\n  DEPLOY = true\n} INACTIVE\n"
      "set MODE = RETURNING\n{\n  MODE = ACTIVE  // the parent\n  RETURN = true\n}\n"
      "set MODE = SURVEYING { MODE = ACTIVE } IDLING\n");
  EXPECT_TRUE(file.odd_lines.empty());
  ASSERT_EQ(file.modes.size(), 3U);
  EXPECT_EQ(file.modes[0].variable, "MODE");
  EXPECT_EQ(file.modes[0].value, "ACTIVE");
  EXPECT_EQ(file.modes[0].otherwise, "INACTIVE");
  ASSERT_EQ(file.modes[1].conditions.size(), 2U);
  EXPECT_EQ(file.modes[1].conditions[1].text, "RETURN = true");
  EXPECT_EQ(file.modes[1].conditions[1].origin, "a:7");
  EXPECT_EQ(file.modes[1].otherwise, "");
  EXPECT_EQ(file.modes[2].value, "SURVEYING");
  EXPECT_EQ(file.modes[2].conditions.at(0).text, "MODE = ACTIVE");
  EXPECT_EQ(file.modes[2].otherwise, "IDLING");
}

TEST(ParseBhvFile, FindsBehaviors) {
  const BhvFile file = Parse(
      "Behavior = BHV_Waypoint\n{\n  name = w   // here\n  points = pts={0,0:1,1}\n}\n"
      "behavior=BHV_Timer {\nduration = 5\n}\n");
  EXPECT_TRUE(file.odd_lines.empty());
  ASSERT_EQ(file.behaviors.size(), 2U);
  EXPECT_EQ(file.behaviors[0].type, "BHV_Waypoint");
  EXPECT_EQ(file.behaviors[0].lines.at(1).value, "pts={0,0:1,1}");
  EXPECT_EQ(file.behaviors[1].type, "BHV_Timer");
  EXPECT_EQ(file.behaviors[1].origin, "a:6");
  EXPECT_EQ(file.behaviors[1].lines.at(0).key, "duration");
}

TEST(ParseBhvFile, JoinsALineThatGoesOnWithTheNext) {
  const BhvFile file =
      Parse("Behavior = BHV_Waypoint\n{\n points = 0,0 : \\\n  10,0 : \\\n 20,0\n speed = 2\n}\n");
  ASSERT_EQ(file.behaviors.at(0).lines.size(), 2U);
  EXPECT_EQ(file.behaviors[0].lines[0].value, "0,0 : 10,0 : 20,0");
  EXPECT_EQ(file.behaviors[0].lines[0].origin, "a:3");
}

TEST(ParseBhvFile, KeepsVariablesInConditionsAndFlags) {
  const BhvFile file = Parse(
      "Behavior = BHV_Timer\n{\n condition = A < $(B)\n endflag = C = $(D)\n pwt = $(E)\n}\n");
  EXPECT_EQ(file.behaviors.at(0).lines.size(), 2U);
  ASSERT_EQ(file.odd_lines.size(), 1U);
  EXPECT_EQ(file.odd_lines[0].reason,
            "is for nsplug: $(E) has no value; give it one with --define NAME=VALUE");
}

TEST(ParseBhvFile, ListsMalformedLinesAndGoesOn) {
  const BhvFile file = Parse(
      "hello\ninitialize X\nset MODE = A {\nB = 1\nBehavior = BHV_Timer\nname = x\n"
      "Behavior = BHV_Loiter\n{\nspeed\nBehavior = BHV_Trail\n{\n");
  std::vector<std::string> odd;
  for (const MoosOddLine& line : file.odd_lines) {
    odd.push_back(line.origin);
    EXPECT_TRUE(line.reason.starts_with("is ")) << line.reason;
  }
  EXPECT_EQ(odd,
            (std::vector<std::string>{"a:1", "a:2", "a:3", "a:5", "a:6", "a:7", "a:9", "a:10"}));
  EXPECT_EQ(file.modes.size(), 1U);
  EXPECT_EQ(file.behaviors.size(), 3U);
}

RC_GTEST_PROP(ParseBhvFile, LosesNoLineOfAnyText, ()) {
  const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "Behavior = BHV_X\n", "{\n", "}\n", "set M = A {\n", "} B\n", "unique = b\n", "junk\n",
      "set M = C\n", "initialize V = 1\n", "Behavior=BHV_Y {\n", "p = $(Q)\n"));
  std::string text;
  size_t num_lines = 0;
  for (const std::string& piece : pieces) {
    text += piece;
    if (piece == "unique = b\n" || piece == "junk\n" || piece == "p = $(Q)\n") ++num_lines;
  }
  const BhvFile file = Parse(text);
  size_t num_found = 0;
  for (const BhvMode& mode : file.modes) {
    for (const MoosLine& line : mode.conditions) {
      num_found += line.text == "unique = b" || line.text == "junk" || line.text == "p = $(Q)";
    }
  }
  for (const BhvBlock& block : file.behaviors) num_found += block.lines.size();
  for (const MoosOddLine& line : file.odd_lines) {
    num_found += line.text == "unique = b" || line.text == "junk" || line.text == "p = $(Q)";
  }
  RC_ASSERT(num_found == num_lines);
}

}  // namespace shoal::bhv_file_test
