#include "lib/mission/toml/polygon_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace shoal::polygon_text_test {

using Points = std::vector<Eigen::Vector2d>;

TEST(PointsText, HoldsPairsBetweenColons) {
  EXPECT_EQ(*ParsePoints("0,0:100,-2.5"), (Points{{0, 0}, {100, -2.5}}));
  EXPECT_EQ(*ParsePoints(" pts = { 0, 0 : 100, 0 } "), (Points{{0, 0}, {100, 0}}));
  EXPECT_EQ(*ParsePoints("{5,6}"), (Points{{5, 6}}));
  for (const char* wrong : {"", "1", "1,2:", "1,2:x,3", "1,2,3", "nan,0"}) {
    EXPECT_FALSE(ParsePoints(wrong).ok()) << wrong;
  }
}

TEST(PolygonText, WritesARegularPolygonByItsRadius) {
  // The golden data's octagon.
  const Points octagon = {{11, 28},   {28, 11},   {28, -11}, {11, -28},
                          {-11, -28}, {-28, -11}, {-28, 11}, {-11, 28}};
  EXPECT_EQ(*ParsePolygon("radial:: x=0,y=0,radius=30,pts=8,snap=1"), octagon);
  EXPECT_EQ(*ParsePolygon("format=radial, x=0, y=0, radius=30, pts=8, snap=1, label=a"), octagon);
  EXPECT_NEAR(ParsePolygon("radial:: x=10, y=0, radius=30, pts=3")->at(0).x(),
              10 + 30 * std::sin(1.0471975511965976), 1e-9);
  EXPECT_EQ(*ParsePolygon("0,0:10,0:10,10"), (Points{{0, 0}, {10, 0}, {10, 10}}));
}

TEST(PolygonText, StatesWhatARadialPolygonLacks) {
  for (const char* wrong :
       {"radial:: x=0,y=0,pts=8", "radial:: x=0,y=0,radius=30,pts=2", "radial:: x=0,radius=3,pts=8",
        "radial:: x=0,y=0,radius=30,pts=1e9", "radial:: x=0,y=0,radius=-1,pts=8"}) {
    const auto polygon = ParsePolygon(wrong);
    ASSERT_FALSE(polygon.ok()) << wrong;
    EXPECT_NE(polygon.error().find("needs x, y, radius > 0 and pts"), std::string::npos);
  }
  EXPECT_NE(ParsePolygon("radial:: x=0,y=zero").error().find("'y=zero' is not key = number"),
            std::string::npos);
}

}  // namespace shoal::polygon_text_test
