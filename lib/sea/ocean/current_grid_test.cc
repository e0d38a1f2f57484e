#include "lib/sea/ocean/current_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace shoal::current_grid_test {

constexpr float kGap = std::numeric_limits<float>::quiet_NaN();

// A field that is linear in all four: interpolation between any points is exact.
double East(double x, double y, double z, double t) {
  return 0.5 + 0.001 * x - 0.002 * y + 0.01 * z + 0.0001 * t;
}
double North(double x, double y, double z, double t) {
  return -0.25 - 0.003 * x + 0.001 * y - 0.02 * z - 0.0002 * t;
}

CurrentGridData LinearField() {
  CurrentGridData data = {.map = GridMap(GridAxis({-100, -20, 0, 90}), GridAxis({-50, 10, 60})),
                          .depths_m = {0.5, 4, 20},
                          .times_s = {-600, 0, 3000}};
  for (const double t : {-600, 0, 3000}) {
    for (const double z : {0.5, 4.0, 20.0}) {
      for (const double y : {-50, 10, 60}) {
        for (const double x : {-100, -20, 0, 90}) {
          data.east_mps.push_back(static_cast<float>(East(x, y, z, t)));
          data.north_mps.push_back(static_cast<float>(North(x, y, z, t)));
        }
      }
    }
  }
  return data;
}

RC_GTEST_PROP(CurrentGrid, IsExactForALinearField, ()) {
  static const CurrentGrid current(LinearField());
  const auto draw = [](int low, int high) { return *rc::gen::inRange(low, high) / 10.0; };
  const double x = draw(-1000, 900);
  const double y = draw(-500, 600);
  const double z = draw(5, 200);
  const double t = draw(-6000, 30'000);
  const Eigen::Vector2d water_mps = current.VelocityAt({x, y, z}, t);
  RC_ASSERT(std::abs(water_mps.x() - East(x, y, z, t)) < 1e-6);
  RC_ASSERT(std::abs(water_mps.y() - North(x, y, z, t)) < 1e-6);
}

TEST(CurrentGrid, IsThatOfTheNearestEdgeDepthAndTimeBeyondThem) {
  const CurrentGrid current(LinearField());
  EXPECT_NEAR(current.VelocityAt({1e5, 10, 4}, 0).x(), East(90, 10, 4, 0), 1e-6);
  EXPECT_NEAR(current.VelocityAt({0, -1e5, 4}, 0).y(), North(0, -50, 4, 0), 1e-6);
  EXPECT_NEAR(current.VelocityAt({0, 10, 0}, 0).x(), East(0, 10, 0.5, 0), 1e-6);
  EXPECT_NEAR(current.VelocityAt({0, 10, 5000}, 0).x(), East(0, 10, 20, 0), 1e-6);
  EXPECT_NEAR(current.VelocityAt({0, 10, 4}, -1e9).x(), East(0, 10, 4, -600), 1e-6);
  EXPECT_NEAR(current.VelocityAt({0, 10, 4}, 1e9).x(), East(0, 10, 4, 3000), 1e-6);
  EXPECT_TRUE(current.IsInside({0, 0}));
  EXPECT_TRUE(current.IsInside({-139, -79}));
  EXPECT_FALSE(current.IsInside({-141, 0}));
  EXPECT_FALSE(current.IsInside({0, 90}));
  EXPECT_FALSE(current.is_steady());
}

/// Two columns 10 m apart, two depths 10 m apart; East in the order above, below.
CurrentGrid TwoColumns(float west_above, float east_above, float west_below, float east_below) {
  return CurrentGrid({.map = GridMap(GridAxis({0, 10}), GridAxis({0})),
                      .depths_m = {0, 10},
                      .times_s = {0},
                      .east_mps = {west_above, east_above, west_below, east_below},
                      .north_mps = {1, 1, 1, 1}});
}

TEST(CurrentGrid, StandsStillOnLandAndFallsTowardIt) {
  const CurrentGrid current = TwoColumns(1, kGap, 1, kGap);
  EXPECT_EQ(current.VelocityAt({10, 0, 0}, 0), Eigen::Vector2d(0, 0));
  EXPECT_EQ(current.VelocityAt({5, 0, 0}, 0), Eigen::Vector2d(0.5, 0.5));
  EXPECT_FALSE(current.IsLand({5, 0}));
  EXPECT_TRUE(TwoColumns(kGap, kGap, kGap, kGap).IsLand({5, 0}));
}

TEST(CurrentGrid, GoesOnBelowItsDeepestValue) {
  const CurrentGrid current = TwoColumns(1, 3, 2, kGap);
  EXPECT_EQ(current.VelocityAt({10, 0, 10}, 0).x(), 3);
  EXPECT_EQ(current.VelocityAt({0, 0, 10}, 0).x(), 2);
  EXPECT_EQ(current.VelocityAt({0, 0, 5}, 0).x(), 1.5);
}

TEST(CurrentGrid, TakesAVectorWithOneComponentForNone) {
  const CurrentGrid current({.map = GridMap(GridAxis({0, 10}), GridAxis({0})),
                             .east_mps = {1, 1},
                             .north_mps = {1, kGap}});
  EXPECT_EQ(current.VelocityAt({10, 0, 0}, 0), Eigen::Vector2d(0, 0));
  EXPECT_TRUE(current.is_steady());
}

TEST(CurrentGrid, InDegreesIsTurnedToTheMissionsPlaneAndFiniteEverywhere) {
  const GeoPoint origin = {.lat_deg = 60, .lon_deg = 5};
  const CurrentGrid current({.map = GridMap(origin, GridAxis({3, 5, 7}), GridAxis({59, 61})),
                             .east_mps = std::vector<float>(6, 0.5F),
                             .north_mps = std::vector<float>(6, 0.25F)});
  EXPECT_EQ(current.VelocityAt({0, 20'000, 0}, 0), Eigen::Vector2d(0.5, 0.25))
      << "to the bit on the origin's meridian";
  const LocalFrame frame(origin);
  const Eigen::Vector2d place_m(90'000, -30'000);
  EXPECT_EQ(current.VelocityAt({place_m.x(), place_m.y(), 0}, 0),
            frame.TurnToPlane({0.5, 0.25}, frame.ToGeo(place_m)));
  for (const double far : {2e6, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(current.VelocityAt({far, -far, 0}, 0).allFinite()) << far;
  }
}

}  // namespace shoal::current_grid_test
