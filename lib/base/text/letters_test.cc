#include "lib/base/text/letters.h"

#include <gtest/gtest.h>

namespace shoal::letters_test {

TEST(Letters, AreThoseOfAsciiAlone) {
  EXPECT_TRUE(IsLetter('a') && IsLetter('z') && IsLetter('A') && IsLetter('Z'));
  for (const char c : {'@', '[', '`', '{', '0', '_', ' ', '\xE4'}) EXPECT_FALSE(IsLetter(c)) << c;
  EXPECT_TRUE(IsNameCharacter('_') && IsNameCharacter('0') && IsNameCharacter('9'));
  EXPECT_FALSE(IsNameCharacter('-') || IsNameCharacter('/') || IsNameCharacter(':'));
}

TEST(Letters, ChangeTheirCaseAndNothingElse) {
  EXPECT_EQ(LowerCase("NODE_Report 7 \xC3\x84"), "node_report 7 \xC3\x84");
  EXPECT_EQ(UpperCase("node_Report 7 \xC3\xA4"), "NODE_REPORT 7 \xC3\xA4");
}

TEST(SameWord, DisregardsCaseAndNotLength) {
  EXPECT_TRUE(IsSameWord("Alpha", "aLPHA"));
  EXPECT_TRUE(IsSameWord("", ""));
  EXPECT_FALSE(IsSameWord("alpha", "alph"));
  EXPECT_FALSE(IsSameWord("alph", "alpha"));
  EXPECT_FALSE(IsSameWord("a_", "A?"));  // '_' and '?' differ by the bit that makes the case.
}

}  // namespace shoal::letters_test
