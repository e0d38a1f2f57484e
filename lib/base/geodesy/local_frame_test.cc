#include "lib/base/geodesy/local_frame.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace shoal::local_frame_test {

constexpr double kPi = std::numbers::pi;
constexpr GeoPoint kOrigin{.lat_deg = 43.8253, .lon_deg = -70.3304};

TEST(LocalFrame, PutsTheOriginAtZero) {
  const LocalFrame frame(kOrigin);
  EXPECT_NEAR(frame.ToGeo({0, 0}).lat_deg, kOrigin.lat_deg, 1e-12);
  EXPECT_NEAR(frame.ToGeo({0, 0}).lon_deg, kOrigin.lon_deg, 1e-12);
  EXPECT_LT(frame.ToLocal(kOrigin)->norm(), 1e-6);
}

TEST(LocalFrame, AgreesWithTheRadiiOfCurvatureOfWgs84) {
  const LocalFrame frame(kOrigin);
  const double a_m = 6378137;
  const double e2 = 0.00669437999014;
  const double lat_rad = kOrigin.lat_deg * kPi / 180;
  const double w2 = 1 - e2 * std::pow(std::sin(lat_rad), 2);
  const double meridian_m = a_m * (1 - e2) / std::pow(w2, 1.5);
  const double parallel_m = a_m / std::sqrt(w2) * std::cos(lat_rad);

  const Eigen::Vector2d north = *frame.ToLocal({kOrigin.lat_deg + 0.001, kOrigin.lon_deg});
  EXPECT_NEAR(north.y(), meridian_m * 0.001 * kPi / 180, 0.001);
  EXPECT_NEAR(north.x(), 0, 1e-6);
  const Eigen::Vector2d east = *frame.ToLocal({kOrigin.lat_deg, kOrigin.lon_deg + 0.001});
  EXPECT_NEAR(east.x(), parallel_m * 0.001 * kPi / 180, 0.001);
  EXPECT_NEAR(east.y(), 0, 0.001);
}

TEST(LocalFrame, HasNoMapForWhatIsOutOfReachOrNoPoint) {
  const LocalFrame frame(kOrigin);
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  for (const GeoPoint& bad : {GeoPoint{nan, 0}, GeoPoint{0, infinity}, GeoPoint{91, 0},
                              GeoPoint{-43.8, 109.7}, GeoPoint{20, -70}, GeoPoint{0, 1e300}}) {
    EXPECT_FALSE(frame.ToLocal(bad).has_value()) << bad.lat_deg << " " << bad.lon_deg;
  }
  EXPECT_TRUE(std::isnan(frame.ToGeo({nan, 0}).lat_deg));
  EXPECT_TRUE(std::isnan(frame.ToGeo({1e300, 0}).lon_deg));
}

TEST(LocalFrame, TurnsEastAndNorthOfAPlaceAsMeridiansConverge) {
  const LocalFrame frame(kOrigin);
  const Eigen::Vector2d along(0.3, -0.7);
  EXPECT_EQ(frame.TurnToPlane(along, kOrigin), along) << "to the bit";
  EXPECT_EQ(frame.TurnToPlane(along, {kOrigin.lat_deg - 3, kOrigin.lon_deg}), along);
  const GeoPoint east = {kOrigin.lat_deg, kOrigin.lon_deg + 1};
  const Eigen::Vector2d here = *frame.ToLocal(east);
  const Eigen::Vector2d north =
      (*frame.ToLocal({east.lat_deg + 1e-4, east.lon_deg}) - here).normalized();
  EXPECT_LT(north.x(), -0.01) << "the meridian of a place in the East leans to the West";
  EXPECT_NEAR((frame.TurnToPlane({0, 1}, east) - north).norm(), 0, 1e-4);
  EXPECT_NEAR(frame.TurnToPlane(along, east).norm(), along.norm(), 1e-15);
  const LocalFrame arctic({.lat_deg = 89.9, .lon_deg = 0});
  EXPECT_NEAR((arctic.TurnToPlane({0, 1}, {89.9, 180}) - Eigen::Vector2d(0, -1)).norm(), 0, 1e-12);
}

TEST(LocalFrame, CrossesTheDateLine) {
  const LocalFrame frame({.lat_deg = -17, .lon_deg = 179.9999});
  EXPECT_LT(frame.ToGeo({500, 0}).lon_deg, -179.9);
  EXPECT_NEAR(frame.ToLocal(frame.ToGeo({500, 0}))->x(), 500, 1e-4);
}

RC_GTEST_PROP(LocalFrame, BringsAPositionBackToWithinAMillimetre, ()) {
  const LocalFrame frame({.lat_deg = *rc::gen::inRange(-89'000, 89'001) / 1000.0,
                          .lon_deg = *rc::gen::inRange(-180'000, 180'001) / 1000.0});
  const auto coordinate = rc::gen::inRange(-200'000, 200'001);
  const Eigen::Vector2d position_m(*coordinate, *coordinate);
  RC_ASSERT((*frame.ToLocal(frame.ToGeo(position_m)) - position_m).norm() < 0.001);
}

}  // namespace shoal::local_frame_test
