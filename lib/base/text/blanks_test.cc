#include "lib/base/text/blanks.h"

#include <gtest/gtest.h>

namespace shoal::blanks_test {

TEST(Trimmed, TakesBlanksOffBothEndsAndNoneFromBetween) {
  EXPECT_EQ(Trimmed(" \t a b\r\n\v\f"), "a b");
  EXPECT_EQ(Trimmed("a"), "a");
}

TEST(Trimmed, LeavesNothingOfBlanksAlone) {
  EXPECT_EQ(Trimmed(" \n\t "), "");
  EXPECT_EQ(Trimmed(""), "");
}

TEST(TrimmedParts, AreThoseBetweenSeparatorsWithoutTheirBlanks) {
  EXPECT_EQ(TrimmedParts(" a, b c ,,d", ','), (std::vector<std::string_view>{"a", "b c", "", "d"}));
  EXPECT_EQ(TrimmedParts("a,", ','), (std::vector<std::string_view>{"a", ""}));
  EXPECT_EQ(TrimmedParts("", ','), std::vector<std::string_view>{""});
}

}  // namespace shoal::blanks_test
