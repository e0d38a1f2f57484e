#include "lib/tools/moos/shell_text.h"

#include <gtest/gtest.h>

#include "lib/tools/moos/shell_sum.h"

namespace shoal::shell_text_test {

TEST(ShellText, IsCutIntoCommandsWithTheirLines) {
  const auto commands = ShellCommandsOf("A=1; B='x;y'  # no\nif [ $A ] ; then\n echo a\\\n b\nfi");
  std::string text;
  for (const ShellCommand& each : commands)
    text += std::to_string(each.line) + ":" + each.text + "|";
  EXPECT_EQ(text, "1:A=1|1:B='x;y'|2:if [ $A ]|2:then|3:echo a  b|5:fi|");
}

TEST(ShellText, KeepsQuotesAndBracketsOfAWordTogether) {
  EXPECT_EQ(RawShellWords("nsplug 'a b' $(echo c d) X=\"e f\""),
            (ShellWords{"nsplug", "'a b'", "$(echo c d)", "X=\"e f\""}));
  EXPECT_EQ(AtShellBlanks(" a  'b c' "), (ShellWords{"a", "'b", "c'"}));
}

TEST(ShellText, MatchesPatternsAsAWhole) {
  EXPECT_TRUE(MatchesShell("a*.moos", "abe.moos"));
  EXPECT_TRUE(MatchesShell("??", "ab"));
  EXPECT_FALSE(MatchesShell("a*", "ba"));
  EXPECT_FALSE(MatchesShell("", "a"));
}

TEST(ShellText, CutsValuesAsBashDoes) {
  EXPECT_EQ(WithoutPrefix("--amt=5=6", "#*="), "5=6");
  EXPECT_EQ(WithoutPrefix("--amt=5=6", "##*="), "6");
  EXPECT_EQ(WithoutSuffix("a.b.moos", "%.*"), "a.b");
  EXPECT_EQ(WithoutSuffix("a.b.moos", "%%.*"), "a");
  EXPECT_EQ(WithoutAll("v12a3", "[^0-9]"), "123");
  EXPECT_EQ(WithoutAll("a-b-c", "-/+"), "a+b+c");
}

TEST(ShellSum, ComputesWithWholeNumbersVariablesAndBrackets) {
  const auto value_of = [](std::string_view name) {
    return name == "X" ? std::string_view("7") : std::string_view();
  };
  EXPECT_EQ(ShellSum("1 + 2 * X", value_of), 15);
  EXPECT_EQ(ShellSum("(1 + 2) * -X % 4", value_of), -1);
  EXPECT_EQ(ShellSum("NONE + 3", value_of), 3);
  EXPECT_EQ(ShellSum("5 / 0", value_of), 0);
  EXPECT_EQ(ShellSum("1000000000 * 9", value_of), 1'000'000'000);
  EXPECT_EQ(ShellSum(std::string(1000, '('), value_of), 0);
}

}  // namespace shoal::shell_text_test
