#include "lib/sea/ocean/grid_map.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <vector>

namespace shoal::grid_map_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(GridAxis, LocatesACoordinateBetweenPointsOfAnyDistance) {
  const GridAxis axis({0, 1, 10});
  const GridPlace place = axis.Locate(5.5);
  EXPECT_EQ(place.before, 1);
  EXPECT_EQ(place.after, 2);
  EXPECT_DOUBLE_EQ(place.share, 0.5);
  EXPECT_EQ(axis.Locate(1).before + axis.Locate(1).share, 1);
}

TEST(GridAxis, EndsInItsLastPointsAndIsOutsideBeyondHalfAStep) {
  const GridAxis axis({0, 2, 10});
  for (const double inside : {-1.0, 0.0, 10.0, 14.0}) EXPECT_TRUE(axis.Locate(inside).is_inside);
  for (const double outside : {-1.01, 14.01, kNan}) EXPECT_FALSE(axis.Locate(outside).is_inside);
  EXPECT_EQ(axis.Locate(-5).before, 0);
  EXPECT_EQ(axis.Locate(-5).share, 0);
  EXPECT_EQ(axis.Locate(99).before, 2);
  EXPECT_EQ(axis.Locate(99).share, 0);
  EXPECT_EQ(axis.Locate(kNan).before, 0);
}

TEST(GridAxis, OfOnePointReachesHalfAStepOrNoFurtherThanItself) {
  EXPECT_TRUE(GridAxis({7}).Locate(7).is_inside);
  for (const double outside : {7.01, -1e9, kNan}) {
    EXPECT_FALSE(GridAxis({7}).Locate(outside).is_inside);
    EXPECT_EQ(GridAxis({7}).Locate(outside).before, 0);
    EXPECT_EQ(GridAxis({7}).Locate(outside).after, 0);
  }
  const GridAxis even = GridAxis::Even(7, 2, 1);
  for (const double inside : {6.0, 7.0, 8.0}) EXPECT_TRUE(even.Locate(inside).is_inside);
  for (const double outside : {5.99, 8.01, kNan}) EXPECT_FALSE(even.Locate(outside).is_inside);
}

RC_GTEST_PROP(GridAxis, OfEvenStepsLocatesAsOneOfTheirPoints, ()) {
  const double step = *rc::gen::inRange(1, 1000) / 16.0;
  const int count = *rc::gen::inRange(2, 30);
  const double first = *rc::gen::inRange(-1000, 1000);
  std::vector<double> points;
  for (int i = 0; i < count; ++i) points.push_back(first + step * i);
  const double where = first + step * *rc::gen::inRange(-100, 400) / 10.0;
  const GridPlace even = GridAxis::Even(first, step, count).Locate(where);
  const GridPlace listed = GridAxis(points).Locate(where);
  RC_ASSERT(std::abs(even.before + even.share - listed.before - listed.share) < 1e-9);
  RC_ASSERT(even.is_inside == listed.is_inside);
}

// Rows from South to North: 0 1 / 10 11, at 10 and 10.5 degrees East, 54 and 54.25 North.
const std::vector<float> kFour = {0, 1, 10, 11};

double AtPoint(const GridMap& map, const GeoPoint& origin, double lat_deg, double lon_deg) {
  const auto place_m = LocalFrame(origin).ToLocal({.lat_deg = lat_deg, .lon_deg = lon_deg});
  return map.Interpolate(kFour, map.Locate(place_m.value()));
}

TEST(GridMap, OfDegreesIsLinearInLatitudeAndLongitude) {
  const GeoPoint origin = {.lat_deg = 54.1, .lon_deg = 10.2};
  const GridMap map(origin, GridAxis({10, 10.5}), GridAxis({54, 54.25}));
  EXPECT_TRUE(map.is_geographic());
  EXPECT_NEAR(AtPoint(map, origin, 54, 10), 0, 1e-6);
  EXPECT_NEAR(AtPoint(map, origin, 54.25, 10.5), 11, 1e-6);
  EXPECT_NEAR(AtPoint(map, origin, 54.1, 10.4), 4 + 0.8, 1e-6);
}

TEST(GridMap, CountsLongitudesFromAnywhere) {
  const GeoPoint origin = {.lat_deg = 0.5, .lon_deg = -170};
  for (const double turn : {-360, 0, 360}) {
    const GridMap map(origin, GridAxis({189.5 + turn, 190.5 + turn}), GridAxis({0, 1}));
    EXPECT_NEAR(AtPoint(map, origin, 0.5, -170), 5.5, 1e-6) << turn;
    EXPECT_TRUE(map.Locate({0, 0}).IsInside()) << turn;
    EXPECT_NEAR(AtPoint(map, origin, 0.5, -171.5), 5, 1e-6) << "West of it is its western edge";
    EXPECT_NEAR(AtPoint(map, origin, 0.5, -168), 6, 1e-6);
  }
}

TEST(GridMap, HasAValueWhereThePlaneIsNoMap) {
  const GridMap map({.lat_deg = 54, .lon_deg = 10}, GridAxis({10, 11}), GridAxis({54, 55}));
  const GridCell cell = map.Locate({1e9, kNan});
  EXPECT_FALSE(cell.IsInside());
  EXPECT_EQ(map.Interpolate(kFour, cell), 0);
}

}  // namespace shoal::grid_map_test
