#include "lib/tools/moos/bhv_points.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace shoal::bhv_points_test {

std::string Points(std::string_view text) {
  const Result<BhvPoints> points = ParseBhvPoints(text);
  return points.ok() ? TomlPoints(points->points_m) : points.error();
}

TEST(ParseBhvPoints, ReadsLists) {
  EXPECT_EQ(Points("0,0:100,-5.5 : 1e1,7"), "[[0, 0], [100, -5.5], [10, 7]]");
  EXPECT_EQ(Points("60,-40"), "[[60, -40]]");
  EXPECT_EQ(Points("label,area:1,2:3,4"), "[[1, 2], [3, 4]]");
  EXPECT_EQ(Points("{1,2:3,4}"), "[[1, 2], [3, 4]]");
  EXPECT_EQ(Points("pts={1,2:3,4:5,6},label=area"), "[[1, 2], [3, 4], [5, 6]]");
  EXPECT_EQ(Points("pts=\"1,2:3,4\", edge_color=red"), "[[1, 2], [3, 4]]");
  EXPECT_EQ(Points("\"1,2:3,4\""), "[[1, 2], [3, 4]]");
  EXPECT_EQ(ParseBhvPoints("1,2,3:4,5,6")->assumed, "a third coordinate of points is not used");
}

// The vertices that golden/helm names for this text.
TEST(ParseBhvPoints, PutsACirclesVerticesWhereMoosIvpHasThem) {
  const std::string golden =
      "[[11, 28], [28, 11], [28, -11], [11, -28], [-11, -28], [-28, -11], [-28, 11], [-11, 28]]";
  EXPECT_EQ(Points("radial:: x=0,y=0,radius=30,pts=8,snap=1"), golden);
  EXPECT_EQ(Points("format=radial, x=0, y=0, radius=30, pts=8, snap=1"), golden);
  EXPECT_EQ(Points("x=0, y=0, format=radial, radius=30, pts=8, snap=1, label=x"), golden);
  EXPECT_EQ(Points("radial:0,0,30,8,1"), golden);
  EXPECT_EQ(Points("radial:: x=10,y=-10,radius=10,pts=4"),
            "[[17.071068, -2.928932], [17.071068, -17.071068], [2.928932, -17.071068], "
            "[2.928932, -2.928932]]");
}

TEST(ParseBhvPoints, TurnsAnEllipse) {
  const std::string upright = "format=ellipse, x=0, y=0, major=40, minor=20, pts=4, snap_value=0.1";
  EXPECT_EQ(Points(upright), "[[7.1, 14.1], [7.1, -14.1], [-7.1, -14.1], [-7.1, 14.1]]");
  EXPECT_EQ(Points(upright + ", degs=90"),
            "[[14.1, -7.1], [-14.1, -7.1], [-14.1, 7.1], [14.1, 7.1]]");
  EXPECT_FALSE(ParseBhvPoints(upright)->assumed.empty());
}

TEST(ParseBhvPoints, LaysOutLanes) {
  const std::string form = "format=lawnmower, x=0, y=0, width=20, height=10, lane_width=10, ";
  EXPECT_EQ(Points(form + "rows=north-south, startx=-50, starty=-50"),
            "[[-10, -5], [-10, 5], [0, 5], [0, -5], [10, -5], [10, 5]]");
  EXPECT_EQ(Points(form + "rows=east - west, startx=50, starty=50"),
            "[[10, 5], [-10, 5], [-10, -5], [10, -5]]");
  EXPECT_EQ(Points(form + "rows=ns, startx=-50, starty=50, degs=90"),
            "[[-5, 10], [5, 10], [5, 0], [-5, 0], [-5, -10], [5, -10]]");
}

TEST(ParseBhvPoints, RefusesWhatMakesNoPoints) {
  for (const char* text :
       {"", ":", "1", "1,", "a", "start", "1,2:x", "1,nan", "format=zigzag, startx=2", "label=x",
        "radial:: x=0,y=0,radius=30", "radial:: x=0,y=0,radius=-1,pts=8",
        "radial:: x=0,y=0,radius=3,pts=1e9", "radial:0,0,30,8,1,2",
        "format=lawnmower, x=0, y=0, width=1e6, height=10, lane_width=0.01, rows=ns",
        "format=lawnmower, x=0, y=0, width=10, height=10, lane_width=1, rows=up",
        "format=ellipse, x=0, y=0, major=5, pts=8"}) {
    const Result<BhvPoints> points = ParseBhvPoints(text);
    ASSERT_FALSE(points.ok()) << text;
    EXPECT_NE(points.error().find("; write x,y:x,y"), std::string::npos) << points.error();
  }
}

TEST(ParseBhvPoints, HasNoNeighboursInOnePlace) {
  EXPECT_EQ(Points("radial:: x=0,y=0,radius=2,pts=12,snap=2"),
            "[[0, 2], [2, 2], [2, 0], [2, -2], [0, -2], [-2, -2], [-2, 0], [-2, 2]]");
}

RC_GTEST_PROP(ParseBhvPoints, AcceptsAnyText, ()) {
  const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "radial::", "format=ellipse,", "format=lawnmower,", "pts=", "x=0,", "y=1,", "radius=", "5,",
      "8", "1e300", "-1", ",", ":", "{", "}", "\"", "label,a", "rows=ns,", "width=9,", "height=9,",
      "lane_width=", "0.001,", "snap=", "nan", "\xff"));
  std::string text;
  for (const std::string& word : words) text += word;
  const Result<BhvPoints> points = ParseBhvPoints(text);
  if (!points.ok()) return;
  RC_ASSERT(!points->points_m.empty());
  RC_ASSERT(points->points_m.size() <= 10'000U);
  for (const Eigen::Vector2d& point_m : points->points_m) RC_ASSERT(point_m.allFinite());
}

}  // namespace shoal::bhv_points_test
