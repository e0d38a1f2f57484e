#include "lib/behaviors/stay_inside.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/geometry/angles.h"
#include "lib/random/stream.h"

namespace shoal::stay_inside_test {

const Polygon kSquare = {{-50, -50}, {-50, 50}, {50, 50}, {50, -50}};
const Domain kDomain;

TEST(StayInside, AllowsEverythingFarFromTheBorder) {
  EXPECT_TRUE(StayInside(kSquare, {0, 0}, 5, kDomain).speeds.empty());
}

TEST(StayInside, AllowsTowardTheBorderTheDistancePerHorizon) {
  const Allowed allowed = StayInside(kSquare, {40, 0}, 5, kDomain);
  EXPECT_EQ(allowed.speeds[90], (IndexRange{.first = 0, .last = 20}));  // 2 m/s for 10 m.
  EXPECT_EQ(allowed.speeds[60], (IndexRange{.first = 0, .last = 23}));
  EXPECT_EQ(allowed.speeds[0], (IndexRange{.first = 0, .last = 40}));
  EXPECT_EQ(allowed.speeds[270], (IndexRange{.first = 0, .last = 40}));
}

TEST(StayInside, AllowsOutsideOnlyWhatLeadsBackIn) {
  const Allowed allowed = StayInside(kSquare, {60, 0}, 5, kDomain);
  EXPECT_EQ(allowed.speeds[270], (IndexRange{.first = 20, .last = 40}));
  EXPECT_TRUE(allowed.speeds[0].empty());
  EXPECT_TRUE(allowed.speeds[90].empty());
}

/// A convex polygon of corners on a circle, at times counter-clockwise.
Polygon DrawPolygon(Stream& stream) {
  std::vector<double> bearings_deg;
  for (int i = 0; i < 3 + static_cast<int>(stream.UniformInt(6)); ++i) {
    bearings_deg.push_back(360 * stream.Uniform());
  }
  std::sort(bearings_deg.begin(), bearings_deg.end());
  if (stream.Uniform() < 0.5) std::reverse(bearings_deg.begin(), bearings_deg.end());
  Polygon polygon_m;
  for (const double bearing_deg : bearings_deg) {
    polygon_m.push_back(40 * UnitVector(DegToRad(bearing_deg)));
  }
  return polygon_m;
}

RC_GTEST_PROP(StayInside, AllowsExactlyWhatEndsInside, ()) {
  Stream stream(*rc::gen::arbitrary<uint64_t>(), "stay inside");
  const Polygon polygon_m = DrawPolygon(stream);
  RC_PRE(IsConvex(polygon_m));
  const Eigen::Vector2d position_m =
      60 * stream.Uniform() * UnitVector(DegToRad(360 * stream.Uniform()));
  const double horizon_s = 1 + 10 * stream.Uniform();
  const Domain domain = {.speed_mps = {.first = 0, .step = 0.5, .count = 9}};
  const Allowed allowed = StayInside(polygon_m, position_m, horizon_s, domain);
  RC_CLASSIFY(allowed.speeds.empty());
  for (size_t course = 0; course < 360; course += 5) {
    const Eigen::Vector2d ahead = UnitVector(DegToRad(static_cast<double>(course)));
    for (int speed = 0; speed < domain.speed_mps.count; ++speed) {
      const double outside_m =
          SignedDistance(polygon_m, position_m + domain.speed_mps.At(speed) * horizon_s * ahead);
      const bool is_allowed = allowed.speeds.empty() || allowed.speeds[course].Has(speed);
      if (std::abs(outside_m) > 1e-6) RC_ASSERT(is_allowed == (outside_m < 0));
    }
  }
}

}  // namespace shoal::stay_inside_test
