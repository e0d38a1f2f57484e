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

}  // namespace shoal::blanks_test
