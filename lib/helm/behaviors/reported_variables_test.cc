#include "lib/helm/behaviors/reported_variables.h"

#include <gtest/gtest.h>

namespace shoal::reported_variables_test {

TEST(IsReportedVariable, KnowsTheVesselsOwnByTheirWholeName) {
  for (const char* name : {"NAV_X", "NAV_Y", "NAV_HEADING", "NAV_SPEED", "NAV_DEPTH"}) {
    EXPECT_TRUE(IsReportedVariable(name)) << name;
  }
  for (const char* name :
       {"NAV_YAW", "NAV_XY", "NAV_SPEED_OVER_GROUND", "NAV_HEADING_OVER_GROUND", "NAV", ""}) {
    EXPECT_FALSE(IsReportedVariable(name)) << name;
  }
}

TEST(IsReportedVariable, KnowsThoseOfBehaviorsWithTheirSuffix) {
  EXPECT_TRUE(IsReportedVariable("WPT_INDEX"));
  EXPECT_TRUE(IsReportedVariable("WPT_STAT_LEG"));
  EXPECT_TRUE(IsReportedVariable("TIME_AT_SURFACE"));
  EXPECT_FALSE(IsReportedVariable("WPT_STATUS"));
  EXPECT_FALSE(IsReportedVariable("WPT_DIST_TO_NEXT"));
  EXPECT_FALSE(IsReportedVariable("GO"));
}

}  // namespace shoal::reported_variables_test
