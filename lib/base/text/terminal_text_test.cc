#include "lib/base/text/terminal_text.h"

#include <gtest/gtest.h>

namespace shoal::terminal_text_test {

TEST(TerminalText, LosesWhatATerminalExecutes) {
  EXPECT_EQ(TerminalText("a\x1b[2Jb\rc\x07"), "a?[2Jb?c?");
  EXPECT_EQ(TerminalText(std::string_view("a\0b", 3)), "a?b");
  EXPECT_EQ(TerminalText("\x7f"), "?");
  EXPECT_EQ(TerminalText("a\xc2\x9b"
                         "2J"),
            "a??2J")
      << "C1, as UTF-8 has it";
  EXPECT_EQ(TerminalText("a\x9b"
                         "2J"),
            "a?2J")
      << "C1, as a terminal of Latin-1 has it";
}

TEST(TerminalText, LosesWhatTurnsTheOrderOfCharactersOrEndsALine) {
  for (const std::string last : {"\x80\xa8", "\x80\xaa", "\x80\xae", "\x81\xa6", "\x81\xa9"}) {
    EXPECT_EQ(TerminalText("a\xe2" + last + "b"), "a???b");
  }
  for (const std::string last : {"\x80\xa7", "\x80\xaf", "\x81\xa5", "\x81\xaa"}) {
    EXPECT_EQ(TerminalText("a\xe2" + last + "b"), "a\xe2" + last + "b");
  }
}

TEST(TerminalText, KeepsCharactersOfAnyLanguage) {
  const std::string text = "F\xc3\xa4hre \xe6\xb5\xb7 \xf0\x9f\x90\x9f \xc2\xa0";
  EXPECT_EQ(TerminalText(text), text);
  EXPECT_EQ(TerminalText("a\nb\tc"), "a\nb c");
}

TEST(TerminalText, HasAMarkForWhatIsNotUtf8) {
  EXPECT_EQ(TerminalText("\xc3"), "?");
  EXPECT_EQ(TerminalText("\xe6\xb5"), "??");
  EXPECT_EQ(TerminalText("\xed\xa0\x80"), "???") << "half of a surrogate pair";
  EXPECT_EQ(TerminalText("\xc0\x8a"), "??") << "a line feed in two bytes";
}

TEST(TerminalLine, IsOneLineOfBoundedLength) {
  EXPECT_EQ(TerminalLine("LOST\nVerdict: PASS"), "LOST?Verdict: PASS");
  EXPECT_EQ(TerminalLine("abcd", 4), "abcd");
  EXPECT_EQ(TerminalLine("abcde", 4), "abcd...");
}

}  // namespace shoal::terminal_text_test
