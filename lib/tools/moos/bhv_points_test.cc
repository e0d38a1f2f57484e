#include "lib/tools/moos/bhv_points.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "lib/tools/moos/quoted_csv_testing.h"

namespace shoal::bhv_points_test {

std::string Points(std::string_view text) {
  const Result<BhvPoints> points = ParseBhvPoints(text);
  return points.ok() ? TomlPoints(points->points_m) : points.error();
}

TEST(ParseBhvPoints, ReadsLists) {
  EXPECT_EQ(Points("0,0:100,-5.5 : 1e1,7"), "[[0, 0], [100, -5.5], [10, 7]]");
  EXPECT_EQ(Points("60,-40"), "[[60, -40]]");
  EXPECT_EQ(Points("label,area:1,2:3,4"), "[[1, 2], [3, 4]]");
  EXPECT_EQ(Points("pts={1,2:3,4:5,6},label=area"), "[[1, 2], [3, 4], [5, 6]]");
  EXPECT_EQ(Points("pts={x=1,y=2:x=3,y=4}, edge_color=red"), "[[1, 2], [3, 4]]");
  EXPECT_EQ(Points("empty"), "[]");
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
  EXPECT_EQ(TomlPoints(ParseBhvPolygon("radial:: x=10,y=-10,radius=10,pts=4")->points_m),
            "[[17.071068, -2.928932], [17.071068, -17.071068], [2.928932, -17.071068], "
            "[2.928932, -2.928932]]");
}

TEST(ParseBhvPoints, MakesOfEveryGoldenTextTheVerticesThatMoosIvpMakes) {
  size_t num_rows = 0;
  for (const GoldenRow& row : ReadQuotedCsv("moos_import/points.csv")) {
    const std::string& reader = row.at("read_by");
    const std::string& text = row.at("text");
    SCOPED_TRACE(row.at("number") + " " + reader + " " + text);
    // A behavior file's quotes are not the library's.
    if (!reader.starts_with("lib_") || text.starts_with('"')) continue;
    const Result<BhvPoints> points = reader == "lib_segl"   ? ParseBhvSeglist(text)
                                     : reader == "lib_poly" ? ParseBhvPolygon(text)
                                                            : ParseBhvPoint(text);
    ++num_rows;
    EXPECT_EQ(points.ok(), row.at("result") != "refused");
    if (!points.ok()) continue;
    std::istringstream vertices(row.at("vertices"));
    size_t i = 0;
    for (std::string vertex; vertices >> vertex; ++i) {
      ASSERT_LT(i, points->points_m.size());
      const size_t comma = vertex.find(',');
      EXPECT_NEAR(points->points_m[i].x(), std::stod(vertex), 1e-3);
      EXPECT_NEAR(points->points_m[i].y(), std::stod(vertex.substr(comma + 1)), 1e-3);
    }
    EXPECT_EQ(i, points->points_m.size());
  }
  EXPECT_GT(num_rows, 55U);
}

TEST(ParseBhvPoints, RefusesWhatMakesNoPoints) {
  for (const char* text :
       {"", ":", "1", "1,", "a", "start", "1,2:x", "1,nan", "format=zigzag, startx=2", "label=x",
        "{1,2:3,4}", "zigzag: 0,0,90,1e9,1,1", "radial:: x=0,y=0,radius=30",
        "radial:: x=0,y=0,radius=-1,pts=8", "radial:: x=0,y=0,radius=3,pts=1e9",
        "radial:0,0,30,8,1,2,3",
        "format=lawnmower, x=0, y=0, width=1e6, height=10, lane_width=0.01, rows=ns",
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
      "lane_width=", "0.001,", "snap=", "nan", "\xff", "zigzag:", "oval:", "rad=", "len=9",
      "wedge:", "pylon:", "bowtie"));
  std::string text;
  for (const std::string& word : words) text += word;
  const Result<BhvPoints> points = ParseBhvPoints(text);
  if (!points.ok()) return;
  RC_ASSERT(points->points_m.size() <= 10'000U);
  for (const Eigen::Vector2d& point_m : points->points_m) RC_ASSERT(point_m.allFinite());
}

}  // namespace shoal::bhv_points_test
