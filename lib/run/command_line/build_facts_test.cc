#include "lib/run/command_line/build_facts.h"

#include <gtest/gtest.h>

#include "lib/base/arithmetic/arithmetic_id.h"

namespace shoal::build_facts_test {

const BuildFacts kOwn = {.version = "0.2.0", .build = "b1", .arithmetic = "a1"};

TEST(Builds, ShareAMissionWhereOnlyTheirIdsDiffer) {
  EXPECT_EQ(WhyNotTogether({.version = "0.2.0", .build = "b2", .arithmetic = "a1"}, kOwn), "");
}

TEST(Builds, OfAnotherArithmeticAreRefusedThoughTheirIdsAreTheSame) {
  const std::string why =
      WhyNotTogether({.version = "0.2.0", .build = "b1", .arithmetic = "a2"}, kOwn);
  EXPECT_TRUE(why.starts_with("its arithmetic is a2, not a1, so that")) << why;
}

TEST(Builds, OfAnotherVersionAreRefused) {
  EXPECT_EQ(WhyNotTogether({.version = "0.3.0", .build = "b2", .arithmetic = "a1"}, kOwn),
            "its shoal is 0.3.0, not 0.2.0: install the same version on both");
}

// Such as a home of 0.2.0, which stated its build alone.
TEST(Builds, ThatStateNothingAreRefused) {
  EXPECT_TRUE(WhyNotTogether({.build = "b1"}, kOwn).starts_with("its shoal is unknown, not 0.2.0"));
}

TEST(Builds, AreShownWithTheirArithmetic) {
  EXPECT_EQ(TextOf(kOwn), "0.2.0 (build b1, arithmetic a1)");
  EXPECT_EQ(OwnBuild().arithmetic, ArithmeticId());
  EXPECT_EQ(WhyNotTogether(OwnBuild(), OwnBuild()), "");
}

}  // namespace shoal::build_facts_test
