#include "lib/comms/moos_wire/moos_glob.h"

#include <gtest/gtest.h>

#include <string>

namespace shoal::moos_glob_test {

TEST(MoosGlob, FitsWholeNamesWithStarsAndQuestionMarks) {
  EXPECT_TRUE(MatchesMoosGlob("NAV_*", "NAV_X"));
  EXPECT_TRUE(MatchesMoosGlob("*", ""));
  EXPECT_TRUE(MatchesMoosGlob("NAV_?", "NAV_X"));
  EXPECT_TRUE(MatchesMoosGlob("*_X*Y", "NAV_XXY"));
  EXPECT_TRUE(MatchesMoosGlob("", ""));
  EXPECT_FALSE(MatchesMoosGlob("NAV_?", "NAV_"));
  EXPECT_FALSE(MatchesMoosGlob("NAV_*", "nav_x"));
  EXPECT_FALSE(MatchesMoosGlob("NAV_X", "NAV_XY"));
  EXPECT_FALSE(MatchesMoosGlob("", "A"));
  EXPECT_FALSE(MatchesMoosGlob("*B", "ABA"));
}

TEST(MoosGlob, TakesNoMoreThanTheProductOfTheLengths) {
  // A matcher that tries each way for each star would never end.
  std::string pattern;
  for (int i = 0; i < 200; ++i) pattern += "*a";
  EXPECT_FALSE(MatchesMoosGlob(pattern + "b", std::string(2000, 'a')));
}

}  // namespace shoal::moos_glob_test
