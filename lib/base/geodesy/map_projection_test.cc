#include "lib/base/geodesy/map_projection.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace shoal::map_projection_test {

constexpr double kDegree = 3.14159265358979323846 / 180;
// Of the examples in Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395,
// 1987), pages 266 to 316: Clarke's ellipsoid of 1866 and the international one.
constexpr double kClarke_m = 6'378'206.4;
const double kClarkeFlattening = 1 - std::sqrt(1 - 0.006'768'66);
constexpr double kInternational_m = 6'378'388;
const double kInternationalFlattening = 1 - std::sqrt(1 - 0.006'722'67);

MapProjection Made(const MapProjectionParams& params) {
  const std::optional<MapProjection> map = MapProjection::Make(params);
  EXPECT_TRUE(map.has_value());
  return map.value();
}

void ExpectPlace(const MapProjection& map, const GeoPoint& point, double x_m, double y_m) {
  const Eigen::Vector2d place = map.Forward(point);
  EXPECT_NEAR(place.x(), x_m, 0.1);
  EXPECT_NEAR(place.y(), y_m, 0.1);
  const GeoPoint again = map.Reverse(place);
  EXPECT_NEAR(again.lat_deg, point.lat_deg, 1e-9);
  EXPECT_NEAR(again.lon_deg, point.lon_deg, 1e-9);
}

TEST(MapProjection, IsThatOfSnydersExamples) {
  ExpectPlace(Made({.kind = MapProjectionKind::kLambertConformalConic,
                    .radius_m = kClarke_m,
                    .flattening = kClarkeFlattening,
                    .origin_lat_deg = 23,
                    .central_lon_deg = -96,
                    .first_parallel_deg = 33,
                    .second_parallel_deg = 45}),
              {.lat_deg = 35, .lon_deg = -75}, 1'894'410.9, 1'564'649.5);
  ExpectPlace(Made({.kind = MapProjectionKind::kPolarStereographic,
                    .radius_m = kInternational_m,
                    .flattening = kInternationalFlattening,
                    .origin_lat_deg = -90,
                    .central_lon_deg = -100,
                    .true_scale_lat_deg = -71}),
              {.lat_deg = -75, .lon_deg = 150}, -1'540'033.6, -560'526.4);
  ExpectPlace(Made({.kind = MapProjectionKind::kTransverseMercator,
                    .radius_m = kClarke_m,
                    .flattening = kClarkeFlattening,
                    .central_lon_deg = -75,
                    .scale = 0.9996}),
              {.lat_deg = 40.5, .lon_deg = -73.5}, 127'106.5, 4'484'124.4);
  ExpectPlace(Made({.kind = MapProjectionKind::kMercator,
                    .radius_m = kClarke_m,
                    .flattening = kClarkeFlattening,
                    .central_lon_deg = -180}),
              {.lat_deg = 35, .lon_deg = -75}, 11'688'673.7, 4'139'145.6);
}

TEST(MapProjection, OfARotatedPoleHasItsOriginOppositeTheGridsPole) {
  const MapProjection map = Made(
      {.kind = MapProjectionKind::kRotatedPole, .origin_lat_deg = 39.25, .central_lon_deg = -162});
  const Eigen::Vector2d origin = map.Forward({.lat_deg = 50.75, .lon_deg = 18});
  EXPECT_NEAR(origin.x(), 0, 1e-9);
  EXPECT_NEAR(origin.y(), 0, 1e-9);
  EXPECT_NEAR(map.Forward({.lat_deg = 90, .lon_deg = 0}).y(), 39.25, 1e-9);
  EXPECT_GT(map.Forward({.lat_deg = 50.75, .lon_deg = 18.5}).x(), 0) << "x is East there";
  EXPECT_NEAR(map.NorthBearing_rad({0, 0}), 0, 1e-9);
}

/// Returns the bearing of the y axis by two points of it.
double BearingByPoints(const MapProjection& map, const Eigen::Vector2d& place, double step) {
  const GeoPoint from = map.Reverse(place);
  const GeoPoint to = map.Reverse(place + Eigen::Vector2d(0, step));
  return std::atan2((to.lon_deg - from.lon_deg) * std::cos(from.lat_deg * kDegree),
                    to.lat_deg - from.lat_deg);
}

TEST(MapProjection, StatesWhichWayItsAxesPoint) {
  // A grid of the Arctic whose x axis points 38.25 degrees to the left of East at 19.75 E.
  const MapProjection polar = Made({.kind = MapProjectionKind::kPolarStereographic,
                                    .origin_lat_deg = 90,
                                    .central_lon_deg = 58,
                                    .true_scale_lat_deg = 60});
  const Eigen::Vector2d place = polar.Forward({.lat_deg = 74.66, .lon_deg = 19.75});
  EXPECT_NEAR(polar.NorthBearing_rad(place), -38.25 * kDegree, 1e-9);
  const Eigen::Vector2d flow = ToEastNorth({0.5, 0}, polar.NorthBearing_rad(place));
  EXPECT_NEAR(flow.x(), 0.5 * std::cos(38.25 * kDegree), 1e-9);
  EXPECT_NEAR(flow.y(), 0.5 * std::sin(38.25 * kDegree), 1e-9);
  // On a sphere, where the two points need no correction.
  for (const MapProjectionKind kind :
       {MapProjectionKind::kLambertConformalConic, MapProjectionKind::kTransverseMercator}) {
    const MapProjection map = Made({.kind = kind,
                                    .radius_m = 6'371'000,
                                    .flattening = 0,
                                    .central_lon_deg = 10,
                                    .first_parallel_deg = 50,
                                    .second_parallel_deg = 60});
    const Eigen::Vector2d there = map.Forward({.lat_deg = 55, .lon_deg = 4});
    EXPECT_NEAR(map.NorthBearing_rad(there), BearingByPoints(map, there, 1), 1e-5);
    EXPECT_GT(std::abs(map.NorthBearing_rad(there)), 4 * kDegree);
  }
  const MapProjection rotated =
      Made({.kind = MapProjectionKind::kRotatedPole, .origin_lat_deg = 25, .central_lon_deg = -40});
  EXPECT_NEAR(rotated.NorthBearing_rad({12, -7}), BearingByPoints(rotated, {12, -7}, 1e-5), 1e-5);
}

TEST(MapProjection, IsNothingForNumbersThatNoneHas) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto is_made = [](const MapProjectionParams& params) {
    return MapProjection::Make(params).has_value();
  };
  EXPECT_FALSE(is_made({.kind = MapProjectionKind::kPolarStereographic, .origin_lat_deg = 60}));
  EXPECT_FALSE(is_made({.radius_m = kNan}));
  EXPECT_FALSE(is_made({.radius_m = 6378}));
  EXPECT_FALSE(is_made({.flattening = 298.257}));
  EXPECT_FALSE(is_made({.central_lon_deg = kNan}));
  EXPECT_FALSE(is_made({.scale = 0}));
  EXPECT_FALSE(is_made({.true_scale_lat_deg = 90}));
  EXPECT_FALSE(is_made({.kind = MapProjectionKind::kLambertConformalConic,
                        .first_parallel_deg = 91,
                        .second_parallel_deg = 91}));
  EXPECT_FALSE(is_made({.false_origin_m = {kNan, 0}}));
}

RC_GTEST_PROP(MapProjection, OfARotatedPoleIsUndoneByItsReverse, ()) {
  const auto degrees = [](int most) { return *rc::gen::inRange(-100 * most, 100 * most) / 100.0; };
  const MapProjection map = MapProjection::Make({.kind = MapProjectionKind::kRotatedPole,
                                                 .origin_lat_deg = degrees(89),
                                                 .central_lon_deg = degrees(180),
                                                 .pole_grid_lon_deg = degrees(180)})
                                .value();
  const GeoPoint point = {.lat_deg = degrees(89), .lon_deg = degrees(179)};
  const GeoPoint again = map.Reverse(map.Forward(point));
  RC_ASSERT(std::abs(again.lat_deg - point.lat_deg) < 1e-6);
  RC_ASSERT(std::abs(std::remainder(again.lon_deg - point.lon_deg, 360)) < 1e-4);
}

}  // namespace shoal::map_projection_test
